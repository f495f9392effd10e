#include "fos/picture_job.hpp"

#include <sstream>

#include "catch2.hpp"

using namespace fos;

namespace {

const Panel panel{"δική σου\nline", {2, 1, {1, 2, 3, '\n', 0, 255}}};

}  // namespace

TEST_CASE("pictures to make travel and come back, one after the other") {
  std::istringstream in(encode(PictureJob{"a folder/εικόνα\n.png", {panel, panel, panel}, 400}) +
                        encode(PictureJob{"b.png", {panel}, 0}));
  const auto sheet = read_picture_job(in);
  REQUIRE(sheet);
  CHECK(sheet->path == "a folder/εικόνα\n.png");
  CHECK(sheet->panel_size == 400);
  REQUIRE(sheet->panels.size() == 3);
  CHECK(sheet->panels[2].label == panel.label);
  const auto plain = read_picture_job(in);
  REQUIRE(plain);
  CHECK(plain->path == "b.png");
  CHECK(plain->panel_size == 0);
  CHECK(plain->panels.front().bitmap.rgb == panel.bitmap.rgb);
  CHECK_FALSE(read_picture_job(in));
}

TEST_CASE("what is no picture to make is refused") {
  const std::string one = encode(panel);
  for (const std::string& bytes :
       {std::string("x"), "picture 0 2 1\na" + one + one, "picture -1 1 1\na" + one,
        std::string("picture 400 0 1\na"), "picture 400 1 0\n" + one,
        "picture 400 9999999 1\na" + one, std::string("picture 400 1 1\na"),
        std::string("picture 400 1 5\na")}) {
    INFO(bytes);
    std::istringstream in(bytes);
    CHECK_THROWS(read_picture_job(in));
  }
}
