// The distribution of the marks as a picture.
#pragma once

#include <array>

#include "markup_writer.hpp"

namespace fos::grading {

/// An SVG: a bar for each tenth of the points, with its number above it; also in words, for who
/// does not see it.
void add_histogram(MarkupWriter& out, const std::array<int, 10>& tenths);

}  // namespace fos::grading
