#include "fos/bitmap.hpp"

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
  const std::vector<Panel> back = read_panels(in);
  REQUIRE(back.size() == 2);
  CHECK(back[1].label == panel.label);
  CHECK(back[1].bitmap.width == 2);
  CHECK(back[1].bitmap.rgb == panel.bitmap.rgb);
}

TEST_CASE("what is no panel is refused") {
  for (const char* bytes :
       {"x", "panel 2 1 0\nabc", "panel 0 1 0\n", "panel 99999 1 0\n", "panel 1 1"}) {
    INFO(bytes);
    std::istringstream in(bytes);
    CHECK_THROWS(read_panels(in));
  }
}
