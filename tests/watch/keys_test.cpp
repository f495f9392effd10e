#include "keys.hpp"

#include "catch2.hpp"

using namespace fos;
using Keys = std::vector<Key>;

TEST_CASE("each key in Latin and in Greek letters, small and large") {
  CHECK(KeyReader().take("helncq") ==
        Keys{Key::hint, Key::explain, Key::list, Key::next, Key::check, Key::quit});
  CHECK(KeyReader().take("HELNCQ") == KeyReader().take("helncq"));
  CHECK(KeyReader().take("ηελνψ;") == KeyReader().take("helncq"));
  CHECK(KeyReader().take("ΗΕΛΝΨ:") == KeyReader().take("helncq"));
  CHECK(KeyReader().take("\x04") == Keys{Key::quit});
  CHECK(KeyReader().take("x \nθ€😀") == Keys(6, Key::other));
}

TEST_CASE("a letter may come in two parts") {
  KeyReader keys;
  const std::string eta = "η";
  CHECK(keys.take(eta.substr(0, 1)).empty());
  CHECK(keys.take(eta.substr(1)) == Keys{Key::hint});
  CHECK(keys.take("q") == Keys{Key::quit});
}

TEST_CASE("what an arrow or a function key sends is one key, and no letter of it counts") {
  CHECK(KeyReader().take("\033[A") == Keys{Key::other});
  CHECK(KeyReader().take("\033[15~") == Keys{Key::other});
  CHECK(KeyReader().take("\033[1;5Hq") == Keys{Key::other, Key::quit});
  CHECK(KeyReader().take("\033OHn") == Keys{Key::other, Key::next});
  CHECK(KeyReader().take("\033") == Keys{Key::other});
  CHECK(KeyReader().take("\033q") == Keys{Key::other, Key::quit});
}
