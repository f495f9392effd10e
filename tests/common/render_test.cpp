#include "fos/render.hpp"

#include <vector>

#include "catch2.hpp"
#include "fos/stage.hpp"

using namespace fos;

namespace {

struct Call {
  Vec3 O, D;
  Real t_min, t_max;
};
std::vector<Call> calls;

}  // namespace

namespace fos {

// The stage of this test: remembers what it is asked, and leaves one pixel unwritten.
Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& /*scene*/) {
  calls.push_back({O, D, t_min, t_max});
  if (calls.size() == 2) return unwritten("trace_ray");
  return Color(Real(calls.size()), 0, 0);
}

}  // namespace fos

TEST_CASE("the ray goes through the pixel's corner, on even and odd canvases") {
  View view;
  view.canvas_width = 4;
  view.canvas_height = 2;
  CHECK(canvas_to_viewport(view, 0, 0) == Vec3(-0.5, 0, 1));
  CHECK(canvas_to_viewport(view, 2, 0) == Vec3(0, 0, 1));
  CHECK(canvas_to_viewport(view, 3, 1) == Vec3(0.25, -0.5, 1));
  view.canvas_width = 5;
  view.canvas_height = 5;
  CHECK(canvas_to_viewport(view, 0, 0) == Vec3(Real(-2.5) / 5, Real(1.5) / 5, 1));
  CHECK(canvas_to_viewport(view, 4, 4) == Vec3(Real(1.5) / 5, Real(-2.5) / 5, 1));
  view.canvas_width = 1;
  view.canvas_height = 1;
  CHECK(canvas_to_viewport(view, 0, 0) == Vec3(-0.5, -0.5, 1));
  view.viewport_width = 3;
  view.viewport_height = 2;
  view.projection_plane_d = 7;
  CHECK(canvas_to_viewport(view, 0, 0) == Vec3(-1.5, -1, 7));
}

TEST_CASE("rows come from the top, pixels from the left, and unwritten ones are marked") {
  View view;
  view.canvas_width = 2;
  view.canvas_height = 2;
  view.camera_position = Vec3(1, 2, 3);
  calls.clear();
  std::vector<Color> colors;
  std::vector<int> flags;
  render(Scene(), view, [&](auto row, auto unwritten) {
    colors.insert(colors.end(), row.begin(), row.end());
    flags.insert(flags.end(), unwritten.begin(), unwritten.end());
  });
  REQUIRE(calls.size() == 4);
  CHECK(calls[0].O == Vec3(1, 2, 3));
  CHECK(calls[0].D == Vec3(-0.5, 0, 1));
  CHECK(calls[1].D == Vec3(0, 0, 1));
  CHECK(calls[2].D == Vec3(-0.5, -0.5, 1));
  CHECK(calls[0].t_min == 1);
  CHECK(calls[0].t_max == infinity);
  CHECK(flags == std::vector<int>{0, 1, 0, 0});
  CHECK(colors[1] == Color(0));
  CHECK(colors[3] == Color(4, 0, 0));
}
