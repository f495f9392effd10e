// A picture as text for a terminal, and for Gradescope, which shows no other.
#pragma once

#include <string>

#include "fos/bitmap.hpp"

namespace fos::grading {

/// The picture made smaller, at most `columns` wide, two rows of pixels in a line: each character
/// is ▀ in one of the 256 colors of terminals on another.
std::string half_blocks(const Bitmap& bitmap, int columns);

}  // namespace fos::grading
