#include "half_blocks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace fos::grading {
namespace {

/// The nearest color of the cube of 6 x 6 x 6, or of the greys, which lie closer together.
int terminal_color(const std::uint8_t* rgb) {
  constexpr int levels[] = {0, 95, 135, 175, 215, 255};
  int cube = 16, error = 0;
  for (int i = 0, place = 36; i < 3; ++i, place /= 6) {
    const int* best = std::min_element(std::begin(levels), std::end(levels), [&](int a, int b) {
      return std::abs(a - rgb[i]) < std::abs(b - rgb[i]);
    });
    cube += place * static_cast<int>(best - levels);
    error += (*best - rgb[i]) * (*best - rgb[i]);
  }
  const int grey = std::clamp((rgb[0] + rgb[1] + rgb[2] - 9) / 30, 0, 23);
  int grey_error = 0;
  for (int i = 0; i < 3; ++i) grey_error += (8 + 10 * grey - rgb[i]) * (8 + 10 * grey - rgb[i]);
  return grey_error < error ? 232 + grey : cube;
}

}  // namespace

std::string half_blocks(const Bitmap& bitmap, int columns) {
  if (bitmap.width < 1 || bitmap.height < 1) return "";
  const int width = std::min(columns, bitmap.width);
  const int height = std::max(1, bitmap.height * width / bitmap.width);
  const Bitmap small = shrunk(bitmap, width, height);
  std::string out;
  for (int row = 0; row < height; row += 2) {
    for (int column = 0; column < width; ++column) {
      const auto pixel = [&](int y) {
        return &small.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(column))];
      };
      out += fmt::format("\033[38;5;{}m", terminal_color(pixel(row)));
      out += row + 1 < height ? fmt::format("\033[48;5;{}m▀", terminal_color(pixel(row + 1)))
                              : "\033[49m▀";
    }
    out += "\033[0m\n";
  }
  return out;
}

}  // namespace fos::grading
