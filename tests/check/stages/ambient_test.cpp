// ambient: color times I_A, the same at every point.
#include "stage_under_test.hpp"

using namespace fos;

TEST_CASE("color times the ambient intensity", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 0.3 }"), {60, 30, 15});
}

TEST_CASE("without ambient light it is dark", "[code]") { check_channels(lit(""), {0, 0, 0}); }

TEST_CASE("an intensity over 1 is not cut off: only the picture is", "[code]") {
  check_channels(lit("light { type = ambient  intensity = 1.2 }"), {240, 120, 60});
}

TEST_CASE("the other kinds of light are for later stages", "[code]") {
  check_channels(lit("light { type = ambient      intensity = 0.3 }"
                     "light { type = point        intensity = 0.6  position = (0, 0, 0) }"
                     "light { type = directional  intensity = 0.6  direction = (0, 0, -1) }"),
                 {60, 30, 15});
}

TEST_CASE("what is met at t = 1 exactly is lit too", "[code]") {
  check_channels(pixel_ahead("sphere { center = (0, 0, 0)  radius = 1  color = (200, 100, 50) }"
                             "light { type = ambient  intensity = 0.3 }"),
                 {60, 30, 15});
}

TEST_CASE("pixels of the lecture's scene", "[code]") {
  check_channels(lecture_pixel(300, 400), {51, 0, 0});
  check_channels(lecture_pixel(500, 300), {0, 0, 51});
  check_channels(lecture_pixel(50, 500), {51, 51, 0});
}

TEST_CASE("every pixel of the stage's scenes", "[code]") { check_whole_frames("ambient"); }
