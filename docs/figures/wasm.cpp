// What the browser calls: numbers in, rows of pixels out. The tracer is a stage's own file.
#include <array>
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
std::vector<std::array<std::uint8_t, 4>> rows;

/// Red, green, blue and opaque.
std::array<std::uint8_t, 4> pixel_of(const fos::Color& color) {
  if (!std::isfinite(color.r) || !std::isfinite(color.g) || !std::isfinite(color.b)) {
    return {fos::not_finite_color[0], fos::not_finite_color[1], fos::not_finite_color[2], 255};
  }
  return {fos::nearest_byte(color.r), fos::nearest_byte(color.g), fos::nearest_byte(color.b), 255};
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
  const auto& [mistake, terms, view, scene] = fos::shown_figure();
  const auto width = static_cast<std::size_t>(view.canvas_width);
  rows.resize(width * static_cast<std::size_t>(view.canvas_height));
  auto* pixel = rows.data();
  for (int row = first; row < view.canvas_height; row += step) {
    for (int column = 0; column < view.canvas_width; ++column) {
      const fos::Vec3 D = fos::canvas_to_viewport(view, column, row);
      *pixel++ = pixel_of(fos::trace_ray(view.camera_position, D, 1, fos::infinity, scene));
    }
  }
  return rows.data()->data();
}
