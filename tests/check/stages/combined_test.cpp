// combined: I_P = I_A + the sum over all lights of I_i <N, L_i> / (|N| |L_i|).
//
// lit() looks at P = (0, 0, 2), where N = (0, 0, -1).
#include "stage_under_test.hpp"

using namespace fos;

TEST_CASE("L parallel to N: all of the light is reflected", "[code]") {
  check_channels(lit("light { type = point        intensity = 0.5   position  = (0, 0, 0) }"
                     "light { type = directional  intensity = 0.25  direction = (0, 0, -3) }"),
                 {150, 75, 37.5});
}

TEST_CASE("L perpendicular to N: none of it", "[code]") {
  check_channels(lit("light { type = ambient      intensity = 0.1 }"
                     "light { type = point        intensity = 0.5   position  = (5, 0, 2) }"
                     "light { type = directional  intensity = 0.25  direction = (0, 2, 0) }"),
                 {20, 10, 5});
}

TEST_CASE("beyond 90 degrees a light is ignored, and takes nothing from the others", "[code]") {
  check_channels(lit("light { type = ambient      intensity = 0.1 }"
                     "light { type = point        intensity = 0.5   position  = (0, 0, 9) }"
                     "light { type = directional  intensity = 0.25  direction = (0, 0, 1) }"
                     "light { type = directional  intensity = 0.25  direction = (0, 0, -1) }"),
                 {70, 35, 17.5});
}

TEST_CASE("any number of lights, in any order", "[code]") {
  // 0.5 * 3/5 + 0.25 * 4/5 + 0.1 + 0.25 * 3/5 + 0.05 * 1 = 0.8.
  check_channels(lit("light { type = point        intensity = 0.5   position  = (4, 0, -1) }"
                     "light { type = directional  intensity = 0.25  direction = (0, 3, -4) }"
                     "light { type = ambient      intensity = 0.1 }"
                     "light { type = directional  intensity = 0.25  direction = (-4, 0, -3) }"
                     "light { type = point        intensity = 0.05  position  = (0, 0, -5) }"),
                 {160, 80, 40});
}

TEST_CASE("the sum may exceed 1: only the picture cuts it off", "[code]") {
  check_channels(pixel_ahead("sphere { center = (0, 0, 3)  radius = 1  color = (100, 50, 25) }"
                             "light { type = ambient  intensity = 0.9 }"
                             "light { type = point    intensity = 1.5  position = (0, 0, 0) }"),
                 {240, 120, 60});
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

TEST_CASE("so are five of the other kind", "[code]") {
  // 3/5 of each of 0.05, 0.1, 0.15, 0.2 and 0.25.
  check_channels(lit("light { type = directional  intensity = 0.05  direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.1   direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.15  direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.2   direction = (4, 0, -3) }"
                     "light { type = directional  intensity = 0.25  direction = (4, 0, -3) }"),
                 {90, 45, 22.5});
}

TEST_CASE("pixels of the lecture's scene", "[code]") {
  // x = 0, y = -50: t = 12/5, P = (0, -1/5, 12/5), N = (0, 4/5, -3/5):
  // I = 0.2 + 0.6 * 2.4 / sqrt(11.2) + 0.2 * 0.8 / sqrt(33) = 0.65813.
  check_channels(lecture_pixel(300, 349), {167.824, 0, 0});
  // Just below the sphere's top: 136.501, which a truncation would make 136.
  check_channels(lecture_pixel(300, 300), {136.501, 0, 0});
}

TEST_CASE("every pixel of the stage's scenes", "[code]") { check_whole_frames("combined"); }
