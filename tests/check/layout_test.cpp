#include "layout.hpp"

#include <cstdlib>

#include "catch2.hpp"
#include "preview.hpp"

using namespace fos;

TEST_CASE("columns are characters, not bytes") {
  CHECK(columns_of("") == 0);
  CHECK(columns_of("φως ✓") == 5);
}

TEST_CASE("lines are broken between words, at the width") {
  CHECK(wrapped("one two three", 0, 7) == "one two\nthree\n");
  CHECK(wrapped("ένα δύο τρία", 2, 9) == "  ένα δύο\n  τρία\n");
  CHECK(wrapped("much-too-long-a-word it is", 0, 8) == "much-too-long-a-word\nit is\n");
  CHECK(wrapped("a  table   stays\nline by line", 1, 20) == " a  table   stays\n line by line\n");
  CHECK(wrapped("  a margin stays", 1, 12) == "   a margin\n   stays\n");
  CHECK(wrapped("").empty());
}

TEST_CASE("without colors words are plain") {
  CHECK(Paint(Colors::none).red("x") == "x");
  CHECK(Paint(Colors::some).red("x") == "\033[31mx\033[0m");
}

TEST_CASE("a test's output is no terminal, so it has no colors") {
  unsetenv("NO_COLOR");
  CHECK(colors_of_output() == Colors::none);
}

namespace {

/// Black above, white below; 4 x 4.
Panel black_and_white() {
  Bitmap bitmap{4, 4, {}};
  for (int pixel = 0; pixel < 16; ++pixel) {
    for (int i = 0; i < 3; ++i) bitmap.rgb.push_back(pixel < 8 ? 0 : 255);
  }
  return {"yours: and more", bitmap};
}

}  // namespace

TEST_CASE("a preview has half as many rows as columns, and as much color as there is") {
  CHECK(preview({black_and_white()}, 4, Colors::none) == "  your\n      \n  @@@@\n");
  CHECK(
      preview({black_and_white()}, 2, Colors::full) ==
      "  yo\n"
      "  \033[38;2;0;0;0m\033[48;2;255;255;255m▀\033[38;2;0;0;0m\033[48;2;255;255;255m▀\033[0m\n");
  CHECK_THAT(preview({black_and_white()}, 2, Colors::indexed),
             ContainsSubstring("\033[38;5;16m\033[48;5;231m▀"));
}

TEST_CASE("panels stand side by side, also of different heights") {
  Panel wide = black_and_white();
  wide.bitmap.height = 2;
  wide.bitmap.rgb.resize(24);
  CHECK(preview({black_and_white(), wide}, 4, Colors::none) ==
        "  your  your\n            \n  @@@@      \n");
}
