// A pixel's place and its color.
#pragma once

#include <array>

namespace fos {

struct Pixel {
  int column = 0;  ///< from 0 at the left
  int row = 0;     ///< from 0 at the top
};

/// Red, green, blue, 0..255 and not rounded.
using Channels = std::array<double, 3>;

}  // namespace fos
