#include "fos/render.hpp"

#include <vector>

#include "fos/stage.hpp"
#include "unwritten.hpp"

namespace fos {

Vec3 canvas_to_viewport(const View& view, int column, int row) {
  const Real W = static_cast<Real>(view.canvas_width);
  const Real H = static_cast<Real>(view.canvas_height);
  const Real x = static_cast<Real>(column) - W / 2;
  const Real y = H / 2 - 1 - static_cast<Real>(row);
  return {x * view.viewport_width / W, y * view.viewport_height / H, view.projection_plane_d};
}

void render(const Scene& scene, const View& view, const RowSink& sink, RowInTheMaking& making) {
  const auto width = static_cast<std::size_t>(view.canvas_width);
  making.colors.assign(width, Color(0));
  std::vector<Color>& colors = making.colors;
  std::vector<std::uint8_t> unwritten(width);
  // Copies that trace_ray cannot reach, so that what depends on the row alone is computed once.
  const View own = view;
  const Vec3 O = view.camera_position;
  take_unwritten();
  for (int row = 0; row < own.canvas_height; ++row) {
    for (int column = 0; column < own.canvas_width; ++column) {
      const auto i = static_cast<std::size_t>(column);
      const Vec3 D = canvas_to_viewport(own, column, row);
      colors[i] = trace_ray(O, D, 1, infinity, scene);
      unwritten[i] = take_unwritten() ? 1 : 0;
      making.pixels.store(column + 1, std::memory_order_relaxed);
    }
    making.pixels = 0;
    sink(colors, unwritten);
  }
}

void render(const Scene& scene, const View& view, const RowSink& sink) {
  RowInTheMaking making;
  render(scene, view, sink, making);
}

}  // namespace fos
