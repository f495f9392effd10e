// What the browser calls: numbers in, rows of pixels out. The tracer is a stage's own file.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "export.hpp"
#include "figure.hpp"
#include "fos/byte_rule.hpp"
#include "fos/stage.hpp"

namespace {

std::vector<double> numbers;
std::vector<std::uint8_t> rows;

void append(const fos::Color& color) {
  const bool finite = std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b);
  for (int i = 0; i < 3; ++i) {
    rows.push_back(finite ? fos::nearest_byte(color[i])
                          : fos::not_finite_color[static_cast<std::size_t>(i)]);
  }
  rows.push_back(255);  // opaque
}

}  // namespace

/// Where the page puts that many numbers.
FOS_EXPORT(numbers_at) double* numbers_at(std::size_t count) {
  numbers.resize(count);
  return numbers.data();
}

/// Shows what the numbers say; 0 if they say nothing.
FOS_EXPORT(show) int show() {
  auto figure = fos::figure_of(numbers);
  if (!figure) return 0;
  fos::shown_figure() = std::move(*figure);
  return 1;
}

/// Every `step`th row from `first` on, RGBA.
FOS_EXPORT(rows_from) const std::uint8_t* rows_from(int first, int step) {
  const fos::Figure& figure = fos::shown_figure();
  const fos::View& view = figure.view;
  rows.clear();
  rows.reserve(4 * static_cast<std::size_t>(view.canvas_width) *
               static_cast<std::size_t>(view.canvas_height));
  for (int row = first; row < view.canvas_height; row += step) {
    for (int column = 0; column < view.canvas_width; ++column) {
      const fos::Vec3 D = fos::canvas_to_viewport(view, column, row);
      append(fos::trace_ray(view.camera_position, D, 1, fos::infinity, figure.scene));
    }
  }
  return rows.data();
}
