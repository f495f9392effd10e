#include "drawing.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

namespace fos {
namespace {

constexpr std::size_t width = 32;  // of the drawing, columns; the words stand to its right
constexpr int P_column = 14;       // a character is twice as high as wide
constexpr double L_rows = 4;       // the length of L, in rows

/// A grid of characters, each up to a few bytes.
class Grid {
 public:
  explicit Grid(int rows) : cells_(static_cast<std::size_t>(rows) * width, " ") {}

  void set(int row, int column, std::string_view character) {
    cells_[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] = character;
  }
  std::string line(int row) const {
    std::string out;
    for (std::size_t column = 0; column < width; ++column) {
      out += cells_[static_cast<std::size_t>(row) * width + column];
    }
    return out;
  }

 private:
  std::vector<std::string> cells_;
};

}  // namespace

std::vector<std::string> draw_angle(double degrees, const std::vector<std::string>& words) {
  const double angle = degrees * std::numbers::pi / 180;
  const int above = degrees > 90 ? 3 : 5;  // rows over the surface; N ends in the first of them
  const int below = degrees > 90 ? 5 : 1;
  Grid grid(above + 1 + below);
  for (int column = P_column - 10; column < P_column + 15; ++column) grid.set(above, column, "─");
  // L first, so that N stands over it where they are one.
  constexpr int dots = 6;
  for (int i = 1; i <= dots; ++i) {
    const double along = L_rows * i / dots;
    const int row = above - static_cast<int>(std::lround(along * std::cos(angle)));
    const int column = P_column + static_cast<int>(std::lround(2 * along * std::sin(angle)));
    // Beside N, or where the surface is, a dot would hide more than it shows.
    if (i < dots && (row == above || column == P_column)) continue;
    grid.set(row, i < dots || column > P_column ? column : P_column + 2, i < dots ? "·" : "L");
  }
  for (int row = 1; row < above; ++row) grid.set(row, P_column, "│");
  grid.set(0, P_column, "N");
  grid.set(above, P_column, "┴");
  grid.set(above + 1, P_column - 2, "P");

  std::vector<std::string> lines;
  for (int row = 0; row <= above + below; ++row) {
    std::string line = grid.line(row);
    const auto word = static_cast<std::size_t>(row - 1);
    if (row >= 1 && word < words.size()) line += words[word];
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(std::move(line));
  }
  while (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace fos
