#include "preview.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace fos {
namespace {

using Rgb = std::array<int, 3>;

/// A bitmap made smaller: each pixel the mean of those that it stands for.
class Small {
 public:
  Small(const Bitmap& bitmap, int width, int height)
      : bitmap_(bitmap), width_(width), height_(height) {}

  Rgb at(int column, int row) const {
    const auto [left, right] = range(column, width_, bitmap_.width);
    const auto [top, bottom] = range(row, height_, bitmap_.height);
    Rgb sum{};
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        for (int i = 0; i < 3; ++i) sum[static_cast<std::size_t>(i)] += channel(x, y, i);
      }
    }
    for (int& value : sum) value /= (right - left) * (bottom - top);
    return sum;
  }

 private:
  static std::pair<int, int> range(int i, int count, int size) {
    const int first = i * size / count;
    return {first, std::max(first + 1, (i + 1) * size / count)};
  }
  int channel(int x, int y, int i) const {
    return bitmap_.rgb[static_cast<std::size_t>(3 * (y * bitmap_.width + x) + i)];
  }

  const Bitmap& bitmap_;
  int width_;
  int height_;
};

/// In the 6 x 6 x 6 cube of a terminal's 256 colors.
int indexed(const Rgb& color) {
  const auto level = [](int channel) { return (channel * 5 + 127) / 255; };
  return 16 + 36 * level(color[0]) + 6 * level(color[1]) + level(color[2]);
}

std::string code(Colors colors, int layer, const Rgb& color) {
  return colors == Colors::full
             ? fmt::format("\033[{};2;{};{};{}m", layer, color[0], color[1], color[2])
             : fmt::format("\033[{};5;{}m", layer, indexed(color));
}

/// Two pixels, one above the other, as one character.
std::string cell(Colors colors, const Rgb& above, const Rgb& below) {
  if (colors == Colors::full || colors == Colors::indexed) {
    return code(colors, 38, above) + code(colors, 48, below) + "▀";
  }
  constexpr std::string_view dark_to_light = " .:-=+*%#@";
  const auto brightness = [](const Rgb& c) { return (2 * c[0] + 3 * c[1] + c[2]) / 6; };
  const int mean = (brightness(above) + brightness(below)) / 2;
  return {dark_to_light[static_cast<std::size_t>(mean * 9 / 255)]};
}

std::string padded(const std::string& text, int columns) {
  std::string cut;
  for (const char byte : text) {
    if ((static_cast<unsigned char>(byte) & 0xC0) != 0x80 && columns_of(cut) >= columns) break;
    cut += byte;
  }
  return cut + std::string(static_cast<std::size_t>(columns - columns_of(cut)), ' ');
}

}  // namespace

std::string preview(const std::vector<Panel>& panels, int columns, Colors colors) {
  std::string out;
  int rows = 0;  // of characters, the most that a panel has
  const auto height = [&](const Bitmap& bitmap) {
    return std::max(1, columns * bitmap.height / bitmap.width / 2);
  };
  for (const Panel& panel : panels) {
    out += "  " + padded(panel.label.substr(0, panel.label.find(':')), columns);
    rows = std::max(rows, std::min(columns, height(panel.bitmap)));
  }
  out.erase(out.find_last_not_of(' ') + 1);
  out += "\n";
  for (int row = 0; row < rows; ++row) {
    for (const Panel& panel : panels) {
      const Small small(panel.bitmap, columns, 2 * rows);
      out += "  ";
      for (int column = 0; column < columns; ++column) {
        out += cell(colors, small.at(column, 2 * row), small.at(column, 2 * row + 1));
      }
      if (colors == Colors::full || colors == Colors::indexed) out += "\033[0m";
    }
    out += "\n";
  }
  return out;
}

}  // namespace fos
