// The flag that unwritten() raises, for the render loop.
#pragma once

#include <utility>

namespace fos {

extern bool unwritten_raised;

/// Whether unwritten() was called since the last take_unwritten(). Inline: it is asked at every
/// pixel.
inline bool take_unwritten() { return std::exchange(unwritten_raised, false); }

}  // namespace fos
