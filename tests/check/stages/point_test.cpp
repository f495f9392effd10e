// point: I_A + the sum over the point lights.
//
// lit() looks at P = (0, 0, 2), where N = (0, 0, -1).
#include "stage_under_test.hpp"

using namespace fos;

TEST_CASE("L parallel to N: all of the light is reflected", "[code]") {
  // L = (0, 0, -2), twice as long as N, so that its length must not matter.
  check_channels(lit("light { type = point  intensity = 0.5  position = (0, 0, 0) }"),
                 {100, 50, 25});
}

TEST_CASE("L perpendicular to N: none of it", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 0.1 }"
                     "light { type = point    intensity = 0.5  position = (5, 0, 2) }"),
                 {20, 10, 5});
}

TEST_CASE("beyond 90 degrees the light is ignored", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 0.1 }"
                     "light { type = point    intensity = 0.5  position = (0, 0, 9) }"),
                 {20, 10, 5});
}

TEST_CASE("between them it is the cosine", "[code]") {
  // L = (4, 0, -3), |L| = 5, <N, L> = 3: I = 0.1 + 0.5 * 3/5 = 0.4.
  check_channels(lit("light { type = ambient  intensity = 0.1 }"
                     "light { type = point    intensity = 0.5  position = (4, 0, -1) }"),
                 {80, 40, 20});
}

TEST_CASE("every point light adds its term", "[code]") {
  // 0.5 * 3/5 + 0.25 * 1 + 0 (from behind) = 0.55.
  check_channels(lit("light { type = point  intensity = 0.5   position = (4, 0, -1) }"
                     "light { type = point  intensity = 0.25  position = (0, 0, -7) }"
                     "light { type = point  intensity = 0.5   position = (0, 0, 9) }"),
                 {110, 55, 27.5});
}

TEST_CASE("a larger sphere is lit the same: N has length 1", "[code]") {
  check_channels(pixel_ahead("sphere { center = (0, 0, 7)  radius = 5  color = (200, 100, 50) }"
                             "light { type = point  intensity = 0.5  position = (4, 0, -1) }"),
                 {60, 30, 15});
}

TEST_CASE("a light at P itself adds nothing", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 0.1 }"
                     "light { type = point    intensity = 0.5  position = (0, 0, 2) }"),
                 {20, 10, 5});
}

TEST_CASE("N points outward inside a sphere too", "[code]") {
  // P = (0, 0, 5) and N = (0, 0, 1): a light in the sphere is behind the surface, one beyond is
  // not.
  constexpr std::string_view around =
      "sphere { center = (0, 0, 0)  radius = 5  color = (200, 100, 50) }"
      "light { type = ambient  intensity = 0.1 }";
  check_channels(pixel_ahead(std::string(around).append(
                     "light { type = point  intensity = 0.5  position = (0, 0, 0) }")),
                 {20, 10, 5});
  check_channels(pixel_ahead(std::string(around).append(
                     "light { type = point  intensity = 0.5  position = (0, 0, 9) }")),
                 {120, 60, 30});
}

TEST_CASE("directional lights are for later stages", "[code]") {
  check_channels(lit("light { type = ambient      intensity = 0.1 }"
                     "light { type = directional  intensity = 0.5  direction = (0, 0, -1) }"),
                 {20, 10, 5});
}

TEST_CASE("without any light it is dark", "[code]") { check_channels(lit(""), {0, 0, 0}); }

TEST_CASE("ambient light alone is I_A", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 0.3 }"), {60, 30, 15});
}

TEST_CASE("five lights of a kind are five terms", "[code]") {
  // 3/5 of each of 0.05, 0.1, 0.15, 0.2 and 0.25.
  check_channels(lit("light { type = point  intensity = 0.05  position = (4, 0, -1) }"
                     "light { type = point  intensity = 0.1   position = (4, 0, -1) }"
                     "light { type = point  intensity = 0.15  position = (4, 0, -1) }"
                     "light { type = point  intensity = 0.2   position = (4, 0, -1) }"
                     "light { type = point  intensity = 0.25  position = (4, 0, -1) }"),
                 {90, 45, 22.5});
}

TEST_CASE("more light than white is cut off in each channel by itself", "[code]") {
  check_channels(lit("light { type = point  intensity = 1.5  position = (0, 0, 0) }"),
                 {300, 150, 75});
}

TEST_CASE("pixels of the lecture's scene", "[code]") {
  // x = 0, y = -50: t = 12/5, P = (0, -1/5, 12/5), N = (0, 4/5, -3/5), L = (2, 6/5, -12/5),
  // <N, L> = 12/5: I = 0.2 + 0.6 * 2.4 / sqrt(11.2) = 0.63028.
  check_channels(lecture_pixel(300, 349), {160.722, 0, 0});
  // On the left of the red sphere no light comes from the point: I = 0.2.
  check_channels(lecture_pixel(108, 460), {51, 0, 0});
}

TEST_CASE("every pixel of the stage's scenes", "[code]") { check_whole_frames("point"); }
