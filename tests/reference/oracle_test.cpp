#include "oracle.hpp"

#include "catch2.hpp"
#include "certified_frame.hpp"
#include "generate.hpp"
#include "test_scene.hpp"

using namespace fos::reference;

namespace {

const std::string sphere = "sphere { center = (0, 0, 5) radius = 2 color = (200, 100, 50) }";

}  // namespace

TEST_CASE("a pixel's terms, its widths and its bytes") {
  const fos::SceneText text =
      small_scene(sphere +
                  "light { type = ambient intensity = 0.1 }"
                  "light { type = point intensity = 0.5 position = (4, 0, 0) }"
                  "light { type = directional intensity = 0.25 direction = (0, 0, 3) }");
  const Reference reference = generate(text);
  CHECK(reference.step == -41);
  const Accepted truth = reference.accepted(1, 0, Precision::double53);
  CHECK(truth.certified.sphere == 1);
  CHECK_THAT(truth.certified.point, WithinAbs(0.3, 1e-12));  // 0.5 * 3/5
  CHECK(truth.certified.directional == 0);                   // from behind
  CHECK(truth.certified.point_width > 0);
  CHECK(truth.certified.point_width < 1e-11);
  CHECK(truth.certified.directional_width == 0);

  const ExactScene scene = to_exact(text);
  const auto bytes = certified_frame(scene, reference, ambient | point | directional);
  CHECK(std::vector<int>(bytes.begin() + 3, bytes.begin() + 6) == std::vector<int>{80, 40, 20});
}

TEST_CASE("a color exactly between two bytes goes to the even one") {
  // 0.5 * 255 = 127.5, all of it from the point light: L is parallel to N.
  const fos::SceneText text = small_scene(
      "sphere { center = (0, 0, 5) radius = 2 color = (255, 253, 0) }"
      "light { type = point intensity = 0.5 position = (0, 0, 0) }");
  const auto bytes = certified_frame(to_exact(text), generate(text), point);
  CHECK(std::vector<int>(bytes.begin() + 3, bytes.begin() + 6) == std::vector<int>{128, 126, 0});
}

TEST_CASE("what stays undecided is named, not guessed") {
  // Both terms are irrational, but their sum is 104.5 / 200: what is irrational in N lies along D,
  // and 0.11875 * (3, 0, 4) / 5 + 0.771875 * (12, 0, 5) / 13 is perpendicular to it.
  const ExactScene scene = small_exact_scene(
      "sphere { center = (-4, 0, 6) radius = 1.5 color = (200, 0, 0) }"
      "light { type = directional intensity = 0.11875 direction = (3, 0, 4) }"
      "light { type = directional intensity = 0.771875 direction = (12, 0, 5) }");
  CHECK_THROWS_AS(Oracle(scene, -40).truth(0, 0), UndecidedError);
  CHECK_THROWS_WITH(Oracle(scene, -40).truth(0, 0), ContainsSubstring("(column 0, row 0)"));
}

TEST_CASE("a step that is too coarse for the bytes is refused") {
  const ExactScene scene =
      small_exact_scene(sphere + "light { type = point intensity = 0.5 position = (1, 0, 2) }");
  CHECK_THROWS_AS(Oracle(scene, -2).truth(1, 0), StepError);
}

TEST_CASE("the step follows the brightest kind of light") {
  CHECK(coarsest_step(small_exact_scene("")) == -40);
  CHECK(coarsest_step(small_exact_scene(
            "light { type = point intensity = 600 position = (1, 0, 2) }"
            "light { type = point intensity = 424 position = (1, 0, 2) }")) == -30);
  CHECK(coarsest_step(small_exact_scene(
            "light { type = directional intensity = 1e-3 direction = (1, 0, 2) }")) == -49);
  CHECK_THROWS_AS(coarsest_step(small_exact_scene(
                      "light { type = point intensity = 1e300 position = (1, 0, 2) }")),
                  std::range_error);
}

TEST_CASE("a canvas that is too large for a reference is refused") {
  CHECK_THROWS_AS(generate(fos::parse_scene_text("canvas_size = 1025 x 1024", "test")),
                  std::range_error);
}

TEST_CASE("very bright and very dark lights") {
  for (const char* intensity : {"1e-30", "1e30"}) {
    const Reference reference = generate(small_scene(
        sphere + "light { type = point intensity = " + intensity + " position = (4, 0, 0) }"));
    const Answer answer = reference.accepted(1, 0, Precision::float24).certified;
    CHECK_THAT(answer.point / std::stod(intensity), WithinAbs(0.6, 1e-10));
    CHECK(answer.point_width < 1e-5 * std::stod(intensity));
  }
}
