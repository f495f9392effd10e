#include "scene_source.hpp"

#include <bit>
#include <cstdint>

#include "catch2.hpp"
#include "exact_scene.hpp"
#include "fos/render.hpp"
#include "fos/scene_file.hpp"
#include "fos/stage.hpp"
#include "test_scenes.hpp"

using namespace fos;

// The camera is in one file with the loop over the pixels, which calls this.
Color fos::trace_ray(const Vec3& /*O*/, const Vec3& /*D*/, Real /*t_min*/, Real /*t_max*/,
                     const Scene& /*scene*/) {
  return Color(0);
}

namespace {

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

bool same(const reference::ExactScene& a, const reference::ExactScene& b) {
  bool same = a.width == b.width && a.height == b.height && a.viewport_width == b.viewport_width &&
              a.viewport_height == b.viewport_height && a.camera == b.camera &&
              a.projection_plane_d == b.projection_plane_d &&
              a.background_color == b.background_color && a.ambient == b.ambient &&
              a.spheres.size() == b.spheres.size() && a.lights.size() == b.lights.size();
  for (std::size_t i = 0; same && i < a.spheres.size(); ++i) {
    same = a.spheres[i].center == b.spheres[i].center &&
           a.spheres[i].radius == b.spheres[i].radius && a.spheres[i].color == b.spheres[i].color;
  }
  for (std::size_t i = 0; same && i < a.lights.size(); ++i) {
    same = a.lights[i].is_point == b.lights[i].is_point &&
           a.lights[i].intensity == b.lights[i].intensity &&
           a.lights[i].vector == b.lights[i].vector;
  }
  return same;
}

}  // namespace

TEST_CASE("a scene written anew reads as the same scene") {
  for (const SceneText& scene : all_scenes()) {
    INFO(scene.name);
    const SceneText again = parse_scene_text(source_of(scene), "again");
    CHECK(same(reference::to_exact(scene), reference::to_exact(again)));
    CHECK(again.lights.size() == scene.lights.size());
    for (std::size_t i = 0; i < again.lights.size(); ++i) {
      CHECK(again.lights[i].kind == scene.lights[i].kind);
    }
  }
}

TEST_CASE("only the lights that were chosen are left, in their order") {
  const SceneText scene = lecture_scene();
  const std::vector<std::size_t> some{0, 2};
  const SceneText chosen = parse_scene_text(with_lights(scene, some).source, "chosen");
  REQUIRE(chosen.lights.size() == 2);
  CHECK(chosen.lights[0].kind == LightKind::ambient);
  CHECK(chosen.lights[1].kind == LightKind::directional);
  CHECK(chosen.spheres.size() == 4);
  CHECK(parse_scene_text(with_lights(scene, {}).source, "none").lights.empty());
}

TEST_CASE("the ray alone has the very same D, on every scene") {
  for (const SceneText& scene : all_scenes()) {
    INFO(scene.name);
    const View view = to_scene(scene).view;
    for_some_pixels(scene, 2000, [&](int column, int row) {
      const OneRay ray = one_ray(scene, column, row);
      const View small = to_scene(parse_scene_text(ray.scene.source, "ray")).view;
      const bool is_same = same_bits(canvas_to_viewport(view, column, row),
                                     canvas_to_viewport(small, ray.column, ray.row));
      if (!is_same || small.canvas_width > 4 || small.canvas_height > 4 ||
          small.camera_position != view.camera_position) {
        FAIL_CHECK("column " << column << ", row " << row);
      }
    });
  }
}
