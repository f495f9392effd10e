#include "fos/text.hpp"

#include <cstdlib>

#include "catch2.hpp"

using namespace fos;

namespace {

/// The language that these variables give.
Language language_of(std::initializer_list<std::pair<const char*, const char*>> variables) {
  for (const char* name : {"FOS_LANG", "LC_ALL", "LC_MESSAGES", "LANG"}) unsetenv(name);
  for (const auto& [name, value] : variables) setenv(name, value, 1);
  const Language result = language();
  for (const char* name : {"FOS_LANG", "LC_ALL", "LC_MESSAGES", "LANG"}) unsetenv(name);
  return result;
}

}  // namespace

TEST_CASE("the language comes from --lang, then from the environment") {
  CHECK(language_of({}) == Language::en);
  CHECK(language_of({{"LANG", "el_GR.UTF-8"}}) == Language::el);
  CHECK(language_of({{"LANG", "el_GR.UTF-8"}, {"LC_ALL", "C"}}) == Language::en);
  CHECK(language_of({{"LANG", "el_GR.UTF-8"}, {"LC_ALL", ""}}) == Language::el);
  CHECK(language_of({{"LC_ALL", "en_US.UTF-8"}, {"FOS_LANG", "el"}}) == Language::el);
  CHECK(language_of({{"LANG", "de_DE.UTF-8"}}) == Language::en);
}

TEST_CASE("placeholders are filled in by number, with anything") {
  static constexpr Text text{"{1} before {0}, {1} again", "{0} μετά από {1}"};
  setenv("FOS_LANG", "en", 1);
  CHECK(say(text, {"a", "{0}"}) == "{0} before a, {0} again");
  setenv("FOS_LANG", "el", 1);
  CHECK(say(text, {"α", "β"}) == "α μετά από β");
  unsetenv("FOS_LANG");
}

TEST_CASE("braces that are no placeholder stay") {
  static constexpr Text text{"'sphere {' and {x} {", "«sphere {» και {x} {"};
  setenv("FOS_LANG", "en", 1);
  CHECK(say(text) == "'sphere {' and {x} {");
  unsetenv("FOS_LANG");
}
