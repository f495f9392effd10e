#include "fos/bitmap.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "catch2.hpp"

using namespace fos;

TEST_CASE("a bitmap has the bytes of the byte rule, rows from the top") {
  Frame frame;
  frame.header = {2, 1, Precision::binary64};
  frame.append({{136.501L, 300, -4, std::numeric_limits<long double>::quiet_NaN(), 0, 0}, {0, 0}});
  const Bitmap bitmap = to_bitmap(frame);
  CHECK(bitmap.rgb == std::vector<std::uint8_t>{137, 255, 0, 255, 0, 255});
}

TEST_CASE("panels travel and come back") {
  const Panel panel{"δική σου\nline", {2, 1, {1, 2, 3, '\n', 0, 255}}};
  std::istringstream in(encode(panel) + encode(panel));
  for (int i = 0; i < 2; ++i) {
    const Panel back = read_panel(in);
    CHECK(back.label == panel.label);
    CHECK(back.bitmap.width == 2);
    CHECK(back.bitmap.rgb == panel.bitmap.rgb);
  }
}

TEST_CASE("what is no panel is refused") {
  for (const char* bytes :
       {"", "x", "panel 2 1 0\nabc", "panel 0 1 0\n", "panel 99999 1 0\n", "panel 1 1"}) {
    INFO(bytes);
    std::istringstream in(bytes);
    CHECK_THROWS(read_panel(in));
  }
}

TEST_CASE("a picture made smaller has the mean of what each pixel covers") {
  const Bitmap three{3, 1, {90, 0, 1, 30, 0, 1, 60, 30, 1}};
  CHECK(shrunk(three, 3, 1).rgb == three.rgb);
  CHECK(shrunk(three, 1, 1).rgb == std::vector<std::uint8_t>{60, 10, 1});
  // 1 1/2 pixels each: (90 + 30 / 2) / 1.5, (30 / 2 + 60) / 1.5.
  CHECK(shrunk(three, 2, 1).rgb == std::vector<std::uint8_t>{70, 0, 1, 50, 20, 1});
  const Bitmap upright{1, 3, three.rgb};
  CHECK(shrunk(upright, 1, 2).rgb == std::vector<std::uint8_t>{70, 0, 1, 50, 20, 1});
}

TEST_CASE("a picture made smaller keeps white white at any size") {
  const Bitmap white{37, 23, std::vector<std::uint8_t>(std::size_t{37} * 23 * 3, 255)};
  for (int width = 1; width <= 37; ++width) {
    const Bitmap small = shrunk(white, width, 23 * width / 37 + 1);
    CHECK(std::count(small.rgb.begin(), small.rgb.end(), 255) ==
          static_cast<long>(small.rgb.size()));
  }
}
