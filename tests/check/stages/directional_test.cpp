// directional: I_A + the sum over the directional lights, with one L for the whole scene.
//
// lit() looks at P = (0, 0, 2), where N = (0, 0, -1).
#include "stage_under_test.hpp"

using namespace fos;

TEST_CASE("L parallel to N: all of the light is reflected", "[code]") {
  check_channels(lit("light { type = directional  intensity = 0.5  direction = (0, 0, -3) }"),
                 {100, 50, 25});
}

TEST_CASE("L perpendicular to N: none of it", "[code]") {
  check_channels(lit("light { type = ambient      intensity = 0.1 }"
                     "light { type = directional  intensity = 0.5  direction = (5, 0, 0) }"),
                 {20, 10, 5});
}

TEST_CASE("beyond 90 degrees the light is ignored", "[code]") {
  check_channels(lit("light { type = ambient      intensity = 0.1 }"
                     "light { type = directional  intensity = 0.5  direction = (0, 0, 3) }"),
                 {20, 10, 5});
}

TEST_CASE("between them it is the cosine, whatever the length of L", "[code]") {
  // <N, L> / (|N| |L|) = 3/5: I = 0.1 + 0.5 * 3/5 = 0.4.
  for (const char* direction : {"(4, 0, -3)", "(0.4, 0, -0.3)", "(4e9, 0, -3e9)"}) {
    INFO("direction = " << direction);
    check_channels(lit("light { type = ambient      intensity = 0.1 }"
                       "light { type = directional  intensity = 0.5  direction = " +
                       std::string(direction) + " }"),
                   {80, 40, 20});
  }
}

TEST_CASE("every directional light adds its term", "[code]") {
  // 0.5 * 3/5 + 0.25 * 1 + 0 (from behind) = 0.55.
  check_channels(lit("light { type = directional  intensity = 0.5   direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.25  direction = (0, 0, -1) }"
                     "light { type = directional  intensity = 0.5   direction = (0, 0, 1) }"),
                 {110, 55, 27.5});
}

TEST_CASE("L is the same wherever P is, and N has length 1", "[code]") {
  check_channels(
      pixel_ahead("sphere { center = (0, 0, 70)  radius = 5  color = (200, 100, 50) }"
                  "light { type = directional  intensity = 0.5  direction = (4, 0, -3) }"),
      {60, 30, 15});
}

TEST_CASE("point lights are for other stages", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 0.1 }"
                     "light { type = point    intensity = 0.5  position = (0, 0, 0) }"),
                 {20, 10, 5});
}

TEST_CASE("without any light it is dark", "[code]") { check_channels(lit(""), {0, 0, 0}); }

TEST_CASE("ambient light alone is I_A", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 0.3 }"), {60, 30, 15});
}

TEST_CASE("five lights of a kind are five terms", "[code]") {
  // 3/5 of each of 0.05, 0.1, 0.15, 0.2 and 0.25.
  check_channels(lit("light { type = directional  intensity = 0.05  direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.1   direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.15  direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.2   direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.25  direction = (4, 0, -3) }"),
                 {90, 45, 22.5});
}

TEST_CASE("more light than white is cut off in each channel by itself", "[code]") {
  check_channels(lit("light { type = directional  intensity = 1.5  direction = (0, 0, -1) }"),
                 {300, 150, 75});
}

TEST_CASE("pixels of the lecture's scene", "[code]") {
  // x = 0, y = -50: t = 12/5, P = (0, -1/5, 12/5), N = (0, 4/5, -3/5), L = (1, 4, 4),
  // <N, L> = 4/5: I = 0.2 + 0.2 * 0.8 / sqrt(33) = 0.22785.
  check_channels(lecture_pixel(300, 349), {58.102, 0, 0});
  // The light comes from behind the scene, so most of what faces the camera gets none: I = 0.2.
  check_channels(lecture_pixel(300, 400), {51, 0, 0});
}

TEST_CASE("every pixel of the stage's scenes", "[code]") { check_whole_frames("directional"); }
