// The limits that scene_file.hpp lists, each from both sides: a scene just inside is taken and goes
// through the slides' formulas; one just outside is refused; and not far outside, without the
// refusal, the formulas really break.
#include <cmath>
#include <functional>

#include "catch2.hpp"
#include "common/slides.hpp"
#include "fos/stage.hpp"
#include "scene_of_any_size.hpp"
#include "slides.hpp"

using namespace fos;
using namespace fos::numerics;

// canvas_to_viewport brings the render loop with it, which wants a stage.
Color fos::trace_ray(const Vec3& /*O*/, const Vec3& /*D*/, Real /*t_min*/, Real /*t_max*/,
                     const Scene& /*scene*/) {
  return Color(0);
}

namespace {

using Limits = std::numeric_limits<Real>;

const Wide max = Limits::max();
const Wide min = Limits::min();
const Wide epsilon = Limits::epsilon();
const Wide keeps_digits = std::sqrt(min / epsilon);    // the square of what is longer does
const Wide coordinate = 2 * std::sqrt(min) / epsilon;  // the least but 0
const Wide vanishes =
    std::sqrt(min) * std::sqrt(epsilon) / 4;  // the square of what is shorter does
const Wide longest_D = std::sqrt(Wide{1.5});  // to the corner of a viewport of 1 x 1

/// A scene that depends on one number, and the limit of that number.
struct Limit {
  std::string name;  ///< the condition in scene_file.hpp
  Wide limit;
  /// How far beyond the limit things break: more than 1 above a largest value, less below a
  /// smallest one. How much margin the limit has is seen here.
  Wide breaks_at;
  std::function<std::string(Wide)> scene;
  std::string says;  ///< in the refusal
};

std::string sphere(Wide z, Wide r, Wide x = 0) {
  return fmt::format("sphere {{ center = ({}, 0, {}) radius = {} color = (255, 0, 0) }}\n",
                     decimal(x), decimal(z), decimal(r));
}
/// From behind the camera: I is 1/2 straight ahead, at a sphere on the axis.
const std::string front = "light { type = directional intensity = 0.5 direction = (0, 0, -1) }\n";
std::string point(Wide I, Wide x, Wide z) {
  return fmt::format("light {{ type = point intensity = {} position = ({}, 0, {}) }}\n", decimal(I),
                     decimal(x), decimal(z));
}
SceneText text_of(const Limit& limit, Wide value) {
  // Column 2, row 1 looks straight ahead.
  return parse_scene_text("canvas_size = 4 x 4\n" + limit.scene(value), "f");
}

/// The scene as to_scene would make it without asking whether Real can carry it.
SceneFile unchecked(const SceneText& text) {
  const numerics::SceneOf<Real> raw = numerics::rounded<Real>(text);
  SceneFile file;
  file.view = {
      raw.width, raw.height, raw.viewport_width, raw.viewport_height, raw.projection_plane_d,
      raw.O};
  for (const auto& each : raw.spheres) {
    file.scene.spheres.push_back({each.center, each.radius, Color(255)});
  }
  file.scene.ambient_intensity = raw.ambient_intensity;
  for (const auto& light : raw.point_lights) {
    file.scene.point_lights.push_back({light.intensity, light.vector});
  }
  for (const auto& light : raw.directional_lights) {
    file.scene.directional_lights.push_back({light.intensity, light.vector});
  }
  return file;
}

/// Whether anything that the slides' formulas give is not finite; or, where the scene is such that
/// straight ahead a sphere is seen with I = 1/2, whether it is not.
bool breaks(const SceneText& text, bool half_ahead) {
  if (!slides_stay_finite(unchecked(text))) return true;
  if (!half_ahead) return false;
  const numerics::SceneOf<Real> raw = numerics::rounded<Real>(text);
  const auto seen = numerics::trace_ray(numerics::canvas_to_viewport(raw, 2, 1), raw);
  return seen.sphere != 1 || std::abs(seen.I - Real(0.5)) > Real(0.01);
}

const Limit limits[] = {
    {"2 (2 S max(1, |D|))² <= max", std::sqrt(max / 8) / longest_D / Wide{1.25}, 4,
     [](Wide z) { return sphere(z, z / 4) + front; }, "'center' is too large"},
    {"the same from inside", std::sqrt(max / 8) / longest_D, 4,
     [](Wide r) { return sphere(0, r) + front; }, "'radius' is too large"},
    {"the same through a telescope, for c", std::sqrt(max / 8) / Wide{1.25}, 4,
     [](Wide z) { return view(Wide{1e-3L}, Wide{1e-3L}) + sphere(z, z / 4) + front; },
     "'center' is too large"},
    {"d² >= min / ε", keeps_digits, epsilon / 4,
     [](Wide d) { return view(d, 1000 * coordinate) + sphere(3, 1) + front; },
     "'projection_plane_d' is too small"},
    {"d stays far from √max", std::sqrt(max / 8) / 1024, 4096,
     [](Wide d) { return view(d, 1) + sphere(0, 1) + front; }, "'projection_plane_d' is too large"},
    {"r² >= min / ε", keeps_digits, epsilon / 4, [](Wide r) { return sphere(0, r) + front; },
     "'radius' is too small"},
    {"4 d² r² >= min / ε", std::sqrt(keeps_digits / 2), std::sqrt(epsilon) / 2,
     [](Wide r) {
       return view(std::sqrt(keeps_digits / 2), std::sqrt(keeps_digits)) + sphere(3 * r, r) + front;
     },
     "'radius' is too small"},
    {"r >= 4 √ε |OC|", 1 / (4 * std::sqrt(epsilon)), 16,
     [](Wide z) { return sphere(z, 1) + front; }, "too small for its distance"},
    {"r >= 16 ε (|O| + |C|)", 16 * epsilon * 2 * std::sqrt(Wide{3}), Wide{1} / 1024,
     [](Wide r) {
       return "camera_position = (1, 1, 1)\n" +
              fmt::format("sphere {{ center = (1, 1, {}) radius = {} color = (255, 0, 0) }}\n",
                          decimal(1 + r / 2), decimal(r)) +
              front;
     },
     "too small for its distance"},
    {"4 (|position| + farthest P)² <= max", std::sqrt(max) / 2 - 8, 3,
     [](Wide z) { return sphere(3, 1) + point(Wide{0.5}, 0, -z); }, "|L|² overflows"},
    // P = (0, 0, 2) exactly, and N = (0.6, 0, -0.8).
    {"(ε g / 2)² >= min, of a light", coordinate, vanishes / coordinate,
     [](Wide x) { return sphere(6, 5, -3) + point(1, x, 2); }, "'position' is too small"},
    {"(ε g / 2)² >= min, of the canvas", 8 * coordinate, vanishes / coordinate / 8,
     [](Wide size) { return view(1, size) + sphere(6, 5, -3) + point(1, 0, 2); },
     "'viewport_size' is too small"},
    {"2 I max(1, r) |L| <= max", max / 2 / (10008), 4,
     [](Wide I) { return sphere(3, 1) + point(I, 0, -10000); }, "'intensity' is too large"},
    {"1024 ΣI <= max", max / 1024, 5,
     [](Wide I) {
       return sphere(3, 1) + "light { type = ambient intensity = " + decimal(I) + " }\n";
     },
     "'intensity' is too large"},
};

}  // namespace

TEST_CASE("just inside a limit the slides' formulas hold, beyond it is refused what breaks them") {
  for (const Limit& limit : limits) {
    INFO(limit.name << ", at " << decimal(limit.limit));
    const bool largest = limit.breaks_at > 1;
    const Wide inside = limit.limit * (largest ? Wide{0.99} : Wide{1.01});
    const Wide outside = limit.limit * (largest ? Wide{1.01} : Wide{0.99});
    CHECK(refusal(text_of(limit, inside)).empty());
    CHECK(slides_stay_finite(unchecked(text_of(limit, inside))));
    CHECK_THAT(refusal(text_of(limit, outside)), ContainsSubstring(limit.says));
    const bool half_ahead = !breaks(text_of(limit, inside), true);
    CHECK(breaks(text_of(limit, limit.limit * limit.breaks_at), half_ahead));
  }
}
