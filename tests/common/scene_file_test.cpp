#include "fos/scene_file.hpp"

#include <cstdlib>
#include <limits>

#include "catch2.hpp"
#include "slides.hpp"

using namespace fos;

namespace {

SceneFile scene_of(const std::string& source) { return to_scene(parse_scene_text(source, "f")); }

/// What is said about a scene that Real cannot carry, or "".
std::string refusal(const std::string& source) {
  setenv("FOS_LANG", "en", 1);
  try {
    scene_of(source);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

std::string sphere(const std::string& center, const std::string& radius) {
  return "sphere { center = " + center + " radius = " + radius + " color = (255, 0, 0) }\n";
}
std::string point_light(const std::string& position, const std::string& intensity = "1") {
  return "light { type = point intensity = " + intensity + " position = " + position + " }\n";
}
std::string directional_light(const std::string& direction) {
  return "light { type = directional intensity = 1 direction = " + direction + " }\n";
}

constexpr int max_exponent10 = std::numeric_limits<Real>::max_exponent10;  // 38, 308, 4932
std::string power(double share, const char* digits = "1") {
  return std::string(digits) + "e" + std::to_string(static_cast<int>(share * max_exponent10));
}

}  // namespace

TEST_CASE("numbers are rounded to the nearest Real") {
  const SceneFile file = scene_of(
      "canvas_size = 7 x 5 viewport_size = 0.1 x 0.2 projection_plane_d = 0.3\n"
      "camera_position = (0.1, -0.2, 0.7) background_color = (0.1, 20, 255)\n" +
      sphere("(0.1, 2, 3)", "0.7") + point_light("(0.1, -0.3, 1e3)", "0.6") +
      "light { type = ambient intensity = 0.2 }");
  CHECK(file.view.canvas_width == 7);
  CHECK(file.view.canvas_height == 5);
  // 0.1L is nearer than any Real, and its rounding is what a literal of Real would be.
  CHECK(file.view.viewport_width == static_cast<Real>(0.1L));
  CHECK(file.view.viewport_height == static_cast<Real>(0.2L));
  CHECK(file.view.projection_plane_d == static_cast<Real>(0.3L));
  CHECK(file.view.camera_position == Vec3(Real(0.1L), Real(-0.2L), Real(0.7L)));
  CHECK(file.scene.background_color == Color(Real(0.1L), 20, 255));
  CHECK(file.scene.spheres.at(0).center == Vec3(Real(0.1L), 2, 3));
  CHECK(file.scene.spheres[0].radius == Real(0.7L));
  CHECK(file.scene.ambient_intensity == Real(0.2L));
  CHECK(file.scene.point_lights.at(0).position == Vec3(Real(0.1L), Real(-0.3L), 1000));
}

TEST_CASE("directions are rescaled by a power of two, whatever their length") {
  CHECK(scene_of(directional_light("(1, 4, 4)")).scene.directional_lights.at(0).direction ==
        Vec3(0.125, 0.5, 0.5));
  for (const std::string exponent : {"e-300", "e-30", "e30", "e300"}) {
    INFO(exponent);
    const Vec3 L =
        scene_of(directional_light("(1" + exponent + ", 4" + exponent + ", -4" + exponent + ")"))
            .scene.directional_lights.at(0)
            .direction;
    CHECK(std::abs(L.y) >= Real(0.5));
    CHECK(std::abs(L.y) < 1);
    CHECK(std::abs(L.x / L.y - Real(0.25)) <= std::numeric_limits<Real>::epsilon());
    CHECK(L.z == -L.y);
  }
}

TEST_CASE("a point light so far that its square overflows is told the directional one to write") {
  const std::string refused =
      refusal(sphere("(0, 0, 3)", "1") +
              point_light("(" + power(0.6) + ", -2" + power(0.6, "") + ", 0)", "0.7"));
  CHECK_THAT(refused, ContainsSubstring("f:2:"));
  CHECK_THAT(refused, ContainsSubstring("|L|² overflows"));
  CHECK_THAT(refused, ContainsSubstring(
                          "light { type = directional  intensity = 0.7  direction = (1, -2, 0) }"));
}

TEST_CASE("what Real cannot carry is refused, with the number and the limit") {
  const std::string s = sphere("(0, 0, 3)", "1");
  const std::pair<std::string, std::string> cases[] = {
      {sphere("(0, 0, " + power(0.6) + ")", "1"), "'center' is too large"},
      {sphere("(0, 0, 3)", power(0.6)), "'radius' is too large"},
      {sphere("(0, 0, " + power(-0.7) + ")", power(-0.7)), "'radius' is too small"},
      {sphere("(0, 0, " + power(0.4) + ")", "1"), "this sphere is too small for its distance"},
      {"camera_position = (" + power(0.9) + ", 0, 0)", "'camera_position' is too large"},
      {"camera_position = (" + power(-0.6) + ", 0, 0)", "'camera_position' is too small"},
      {"projection_plane_d = " + power(-0.7), "'projection_plane_d' is too small"},
      {"projection_plane_d = " + power(0.6), "'projection_plane_d' is too large"},
      {"viewport_size = " + power(-0.6) + " x 1", "'viewport_size' is too small"},
      {"viewport_size = 1 x " + power(0.6), "'viewport_size' is too large"},
      {s + point_light("(" + power(-0.6) + ", 0, 0)"), "'position' is too small"},
      {s + point_light("(0, 0, 1)", power(1)), "'intensity' is too large"},
      {"light { type = ambient intensity = " + power(1) + " }", "'intensity' is too large"},
      {sphere("(0, 0, 1e4999)", "1"), "too large"},
      {sphere("(0, 0, 3)", "1e-4999"), "too small"},
  };
  for (const auto& [source, error] : cases) {
    INFO(source);
    CHECK_THAT(refusal(source), ContainsSubstring(error));
  }
}

TEST_CASE("what is just inside the limits goes through the slides' formulas and stays finite") {
  const std::string small = "canvas_size = 8 x 8\n";
  const std::string s = sphere("(0, 0, 3)", "1");
  const std::string sources[] = {
      s + point_light("(0, 0, 2)") + point_light("(0, 0, 0)") + directional_light("(0, 0, -1)"),
      s + point_light("(" + power(0.47) + ", " + power(0.47) + ", 0)"),
      s + point_light("(1, 2, -3)", power(0.9)),
      s + point_light("(" + power(-0.1) + ", 0, 2)"),
      sphere("(0, 0, " + power(0.2, "4") + ")", power(0.2, "3")) + directional_light("(1, 1, -1)"),
      sphere("(0, 0, 30000)", "29999") + point_light("(0, 0, 1)"),
      sphere("(0, 0, 600)", "1") + directional_light("(1e-300, 1e-300, -1e300)"),
      "projection_plane_d = 1e-3 viewport_size = 1e-3 x 1e-3\n" + s + point_light("(0, 1, 0)"),
  };
  for (const std::string& source : sources) {
    INFO(source);
    const std::string refused = refusal(small + source);
    CHECK(refused.empty());
    if (refused.empty()) CHECK(slides_stay_finite(scene_of(small + source)));
  }
}
