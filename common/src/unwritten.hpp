// The flag that unwritten() raises, for the render loop.
#pragma once

namespace fos {

/// Whether unwritten() was called since the last take_unwritten().
bool take_unwritten();

}  // namespace fos
