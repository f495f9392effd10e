#include "right_answers.hpp"

#include <cmath>
#include <numeric>

#include "catch2.hpp"
#include "test_scenes.hpp"

using namespace fos;

namespace {

bool is_about(const Expected& a, const Expected& b) {
  bool about = a.sphere == b.sphere && a.bytes == b.bytes;
  for (std::size_t i = 0; i < 3; ++i) {
    // Stored terms are whole multiples of steps, which may differ.
    about = about && std::abs(a.channels[i].low - b.channels[i].low) < 1e-6 &&
            std::abs(a.channels[i].high - b.channels[i].high) < 1e-6;
  }
  return about;
}

}  // namespace

TEST_CASE("with all lights, what is right is what the reference has") {
  for (const SceneText& scene : all_scenes()) {
    INFO(scene.name);
    const auto name = std::filesystem::path(scene.name).stem().string();
    const reference::Reference data =
        reference::read_reference(std::filesystem::path(FOS_REFERENCE_DATA) / (name + ".ref"));
    std::vector<std::size_t> all(scene.lights.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const unsigned terms : {0U, 3U, 7U}) {
      const Judge whole(data, terms);
      for_some_pixels(scene, 150, [&](int column, int row) {
        const Judge judge = RightAnswers(scene, column, row).judge(all, terms);
        for (const auto precision : reference::precisions) {
          const auto here = judge.expected({0, 0}, precision);
          const auto there = whole.expected({column, row}, precision);
          if (!std::equal(here.begin(), here.end(), there.begin(), there.end(), is_about)) {
            FAIL_CHECK("column " << column << ", row " << row << ", terms " << terms);
          }
        }
      });
    }
  }
}

TEST_CASE("with some lights, their terms and no others") {
  const RightAnswers right(lecture_scene(), 300, 349);
  const auto red = [&](const std::vector<std::size_t>& lights, unsigned terms) {
    const Interval channel = right.judge(lights, terms)
                                 .expected({0, 0}, reference::Precision::double53)
                                 .front()
                                 .channels[0];
    return (channel.low + channel.high) / 2;
  };
  CHECK_THAT(red({}, 7), WithinAbs(0, 1e-9));
  CHECK_THAT(red({0}, 7), WithinAbs(51, 1e-9));
  CHECK_THAT(red({1}, 7), WithinAbs(255 * 1.44 / std::sqrt(11.2), 1e-9));
  CHECK_THAT(red({2}, 7), WithinAbs(255 * 0.16 / std::sqrt(33.0), 1e-9));
  CHECK_THAT(red({0, 2}, 7), WithinAbs(51 + 255 * 0.16 / std::sqrt(33.0), 1e-9));
  CHECK_THAT(red({2}, 3), WithinAbs(0, 1e-9));  // no term of that stage
  CHECK_THAT(red({1}, 0), WithinAbs(255, 1e-9));
}

TEST_CASE("a light too dim for a double alone adds nothing that shows") {
  const SceneText scene = parse_scene_text(
      "canvas_size = 2 x 2\nsphere { center = (0, 0, 3) radius = 1 color = (200, 100, 0) }\n"
      "light { type = directional intensity = 1 direction = (0, 0, -1) }\n"
      "light { type = directional intensity = 1e-290 direction = (0, 0, -1) }\n",
      "scene");
  const std::vector<std::size_t> dim{1};
  const std::vector<Expected> expected =
      RightAnswers(scene, 1, 0).judge(dim, 7).expected({0, 0}, reference::Precision::double53);
  REQUIRE(expected.size() == 1);
  CHECK(expected[0].bytes == std::array<std::uint8_t, 3>{0, 0, 0});
  CHECK(expected[0].channels[0].high < 1e-6);
}
