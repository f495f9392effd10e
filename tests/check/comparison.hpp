// A frame beside the right one: yours, expected, and the signed difference.
#pragma once

#include <optional>
#include <vector>

#include "fos/bitmap.hpp"
#include "judge.hpp"

namespace fos {

/// What differs between a frame and the exact one, pixel by pixel.
struct Difference {
  std::vector<double>
      signed_channels;         ///< a pixel: the channel that differs most; rows from the top
  double largest = 0;          ///< of their absolute values, where finite; 0..255 scale
  std::optional<Pixel> worst;  ///< where it is; the first that is not finite, if there is one
};

/// Only pixels that the judge finds wrong (or unwritten, or not finite) count: what rounding may
/// change is no difference.
Difference difference(const Judge& judge, const Frame& frame);

/// Three labelled panels of the frame's size times a whole number, the worst pixel circled in each.
/// In the third, blue is less and orange more, its full color being the largest difference, which
/// the label states; white is right.
std::vector<Panel> compare(const Judge& judge, const Frame& frame, const Difference& differs);

/// The third panel's colors for each pixel, not magnified: for a preview.
Bitmap to_bitmap(const Difference& difference, int width, int height);

}  // namespace fos
