// flat_color: the closest sphere's color, as it is, or the background.
#include "stage_under_test.hpp"

using namespace fos;

namespace {

constexpr std::string_view orange_in_front =
    "sphere { center = (0, 0, 3)  radius = 1  color = (200, 100, 50) }\n";
constexpr std::string_view blue_behind =
    "sphere { center = (0, 0, 9)  radius = 2  color = (10, 20, 255) }\n";
constexpr Channels orange{200, 100, 50};
constexpr Channels blue{10, 20, 255};
constexpr Channels background{0, 0, 0};

Channels ahead(std::initializer_list<std::string_view> spheres) {
  std::string scene;
  for (const std::string_view sphere : spheres) scene += sphere;
  return pixel_ahead(scene);
}

}  // namespace

TEST_CASE("a ray that meets a sphere sees its color", "[code]") {
  check_channels(ahead({orange_in_front}), orange);
}

TEST_CASE("a ray that meets nothing sees the background", "[code]") {
  check_channels(ahead({"sphere { center = (5, 0, 3)  radius = 1  color = (1, 2, 3) }"}),
                 background);
}

TEST_CASE("the nearer of two spheres hides the other, in either order in the file", "[code]") {
  check_channels(ahead({orange_in_front, blue_behind}), orange);
  check_channels(ahead({blue_behind, orange_in_front}), orange);
}

TEST_CASE("a sphere behind the camera is not seen", "[code]") {
  check_channels(ahead({"sphere { center = (0, 0, -3)  radius = 1  color = (1, 2, 3) }"}),
                 background);
}

TEST_CASE("what lies between the camera and the projection plane is not seen", "[code]") {
  // t is 0.25 and 0.75 there, both below t_min = 1.
  check_channels(
      ahead({"sphere { center = (0, 0, 0.5)  radius = 0.25  color = (1, 2, 3) }", blue_behind}),
      blue);
}

TEST_CASE("just in front of the projection plane is not seen either", "[code]") {
  // t is 0.75 and 0.95.
  check_channels(
      ahead({"sphere { center = (0, 0, 0.85)  radius = 0.1  color = (1, 2, 3) }", blue_behind}),
      blue);
}

TEST_CASE("however far away a sphere is, it is seen", "[code]") {
  check_channels(ahead({"sphere { center = (0, 0, 2e6)  radius = 5e5  color = (10, 20, 255) }"}),
                 blue);
}

TEST_CASE("t_min itself counts: the interval is closed", "[code]") {
  // The camera is at the centre, so the ray leaves the sphere at t = 1 exactly.
  check_channels(ahead({"sphere { center = (0, 0, 0)  radius = 1  color = (10, 20, 255) }"}), blue);
}

TEST_CASE("from inside a sphere its far side is seen", "[code]") {
  check_channels(ahead({"sphere { center = (0, 0, 0)  radius = 5  color = (10, 20, 255) }"}), blue);
}

TEST_CASE("from inside, also where the sphere's centre is behind the camera", "[code]") {
  check_channels(ahead({"sphere { center = (0, 0, -2)  radius = 5  color = (10, 20, 255) }"}),
                 blue);
}

TEST_CASE("colors are real numbers, the background's too", "[code]") {
  constexpr std::string_view sky = "canvas_size = 2 x 2  background_color = (0.5, 127.25, 254.75)";
  check_channels(pixel_of(sky, 1, 0), {0.5, 127.25, 254.75});
  check_channels(ahead({"sphere { center = (0, 0, 3)  radius = 1  color = (0.5, 1.25, 9.75) }"}),
                 {0.5, 1.25, 9.75});
}

TEST_CASE("a ray that only touches a sphere meets it", "[code]") {
  // The discriminant is 0, in numbers that are exact at any precision and in any formulation.
  check_channels(ahead({"sphere { center = (3, 0, 4)  radius = 3  color = (10, 20, 255) }"}), blue);
}

TEST_CASE("pixels of the lecture's scene", "[code]") {
  check_channels(lecture_pixel(300, 400), {255, 0, 0});
  check_channels(lecture_pixel(500, 300), {0, 0, 255});
  check_channels(lecture_pixel(100, 300), {0, 255, 0});
  check_channels(lecture_pixel(50, 500), {255, 255, 0});
  check_channels(lecture_pixel(0, 0), {255, 255, 255});
}

TEST_CASE("every pixel of the stage's scenes", "[code]") { check_whole_frames("flat_color"); }
