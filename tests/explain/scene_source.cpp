#include "scene_source.hpp"

#include <fmt/core.h>

#include "fos/nearest.hpp"

namespace fos {
namespace {

std::string source_of(const DecimalTriple& triple) {
  return fmt::format("({}, {}, {})", triple[0].text, triple[1].text, triple[2].text);
}

std::string source_of(const LightText& light) {
  if (light.kind == LightKind::ambient) {
    return fmt::format("light {{ type = ambient intensity = {} }}\n", light.intensity.text);
  }
  const bool is_point = light.kind == LightKind::point;
  return fmt::format("light {{ type = {} intensity = {} {} = {} }}\n",
                     is_point ? "point" : "directional", light.intensity.text,
                     is_point ? "position" : "direction", source_of(light.vector));
}

/// One side of the canvas: so many pixels, of which one is meant, and the viewport's size.
struct Side {
  int pixels = 0;
  int pixel = 0;
  Decimal viewport;
};

/// A side one of whose pixels has this component of D. It is
///   k viewport / pixels  with k = -1/2 of 1 pixel, 0 of 2, 1 of 4:
/// products and quotients by powers of two, so that nothing is rounded. Where the pixels with
/// k = 0 and 1 are hangs on the direction in which they are counted.
Side side(double along, int at_0_of_2, int at_1_of_4) {
  if (along < 0) return {1, 0, parse_decimal(fmt::format("{}", -2 * along))};
  if (along > 0) return {4, at_1_of_4, parse_decimal(fmt::format("{}", 4 * along))};
  return {2, at_0_of_2, parse_decimal("1")};
}

}  // namespace

std::string source_of(const SceneText& scene) {
  std::string out = fmt::format(
      "canvas_size = {} x {}\nviewport_size = {} x {}\nprojection_plane_d = {}\n"
      "camera_position = {}\nbackground_color = {}\n",
      scene.canvas_width, scene.canvas_height, scene.viewport_size[0].text,
      scene.viewport_size[1].text, scene.projection_plane_d.text, source_of(scene.camera_position),
      source_of(scene.background_color));
  for (const SphereText& sphere : scene.spheres) {
    out += fmt::format("sphere {{ center = {} radius = {} color = {} }}\n",
                       source_of(sphere.center), sphere.radius.text, source_of(sphere.color));
  }
  for (const LightText& light : scene.lights) out += source_of(light);
  return out;
}

SceneText with_lights(const SceneText& scene, std::span<const std::size_t> lights) {
  SceneText some = scene;
  some.lights.clear();
  for (const std::size_t i : lights) some.lights.push_back(scene.lights[i]);
  some.source = source_of(some);
  return some;
}

OneRay one_ray(const SceneText& scene, int column, int row) {
  // As a stage program computes it, in doubles (render.hpp).
  const double W = scene.canvas_width;
  const double H = scene.canvas_height;
  const double D_x = (column - W / 2) * nearest<double>(scene.viewport_size[0]) / W;
  const double D_y = (H / 2 - 1 - row) * nearest<double>(scene.viewport_size[1]) / H;
  const Side across = side(D_x, 1, 3);  // x = c - W/2
  const Side down = side(D_y, 0, 0);    // y = H/2 - 1 - r
  OneRay ray{scene, across.pixel, down.pixel};
  ray.scene.canvas_width = across.pixels;
  ray.scene.canvas_height = down.pixels;
  ray.scene.viewport_size = {across.viewport, down.viewport};
  ray.scene.source = source_of(ray.scene);
  return ray;
}

}  // namespace fos
