// Pictures in memory, as bytes: what a PNG shows, and what is put side by side on a sheet.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "fos/frame.hpp"

namespace fos {

/// 8-bit pixels, 3 bytes each, rows from the top.
struct Bitmap {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The bytes that a PNG of the frame holds.
Bitmap to_bitmap(const Frame& frame);

/// The same picture made smaller, neither side becoming longer: each pixel is the mean of what it
/// covers, also where it covers a part of a pixel.
Bitmap shrunk(const Bitmap& bitmap, int width, int height);

/// A picture with its label, for a sheet.
struct Panel {
  std::string label;
  Bitmap bitmap;
};

/// How panels travel to the picture program: a line `panel WIDTH HEIGHT LABEL_BYTES`, the label,
/// the pixels.
std::string encode(const Panel& panel);

/// The next panel. Throws std::runtime_error where there is something else, or nothing.
Panel read_panel(std::istream& in);

}  // namespace fos
