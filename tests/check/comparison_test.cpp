#include "comparison.hpp"

#include "catch2.hpp"
#include "fos/stage_list.hpp"

using namespace fos;

namespace {

const Judge& judge() {
  static const Judge inside(reference::read_reference(FOS_REFERENCE_DATA "/inside.ref"),
                            ambient_term | point_term);
  return inside;
}

std::array<int, 3> color(const Bitmap& bitmap, Pixel pixel) {
  const auto first = static_cast<std::size_t>(3 * (pixel.row * bitmap.width + pixel.column));
  return {bitmap.rgb[first], bitmap.rgb[first + 1], bitmap.rgb[first + 2]};
}

}  // namespace

TEST_CASE("the right frame differs nowhere") {
  const Difference none = difference(judge(), judge().exact());
  CHECK(none.largest == 0);
  CHECK_FALSE(none.worst);
  const auto panels = compare(judge(), judge().exact(), none);
  REQUIRE(panels.size() == 3);
  for (const std::uint8_t channel : panels[2].bitmap.rgb) REQUIRE(channel == 255);
}

TEST_CASE("less is blue, more is orange, the largest is the worst") {
  Frame frame = judge().exact();
  const auto width = static_cast<std::size_t>(frame.header.width);
  frame.channels[3 * (5 * width + 2)] += 10;
  frame.channels[3 * (6 * width + 7)] -= 40;
  const Difference two = difference(judge(), frame);
  CHECK(two.largest == 40);
  REQUIRE(two.worst);
  CHECK(two.worst->column == 7);
  CHECK(two.worst->row == 6);
  const Bitmap map = to_bitmap(two, frame.header.width, frame.header.height);
  CHECK(color(map, {7, 6}) == std::array{33, 102, 172});
  const auto [r, g, b] = color(map, {2, 5});
  CHECK(r > g);
  CHECK(g > b);
  CHECK(color(map, {3, 5}) == std::array{255, 255, 255});
}

TEST_CASE("what is not finite comes before any difference") {
  Frame frame = judge().exact();
  frame.channels[0] += 100;
  frame.channels[3 * 9 + 1] = std::numeric_limits<long double>::quiet_NaN();
  const Difference two = difference(judge(), frame);
  REQUIRE(two.worst);
  CHECK(two.worst->column == 9);
  CHECK(two.largest == 100);
}

TEST_CASE("the worst pixel is circled in each of three large panels") {
  Frame frame = judge().exact();
  const int center = frame.header.width / 2;
  const auto index = static_cast<std::size_t>(center * frame.header.width + center);
  frame.channels[3 * index] += 40;
  const auto panels = compare(judge(), frame, difference(judge(), frame));
  REQUIRE(panels.size() == 3);
  for (const Panel& panel : panels) {
    CHECK(panel.bitmap.width > 200);
    const int times = panel.bitmap.width / frame.header.width;
    const int middle = times * center + times / 2;
    const int radius = panel.bitmap.width / 24;
    CHECK(color(panel.bitmap, {middle + radius, middle}) == std::array{0, 0, 0});
    CHECK(color(panel.bitmap, {middle, middle - radius}) == std::array{0, 0, 0});
  }
  CHECK_THAT(panels[2].label, ContainsSubstring("40"));
}
