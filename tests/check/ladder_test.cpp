// The hints: that there are enough of them, that they are climbed one by one, that they fit.
#include "ladder.hpp"

#include <fstream>
#include <sstream>

#include "../common/folder.hpp"
#include "catch2.hpp"
#include "fos/whole_file.hpp"
#include "layout.hpp"
#include "stage_test.hpp"

using namespace fos;

namespace {

const Stage& first_stage() { return *std::begin(stages); }

std::string climb(const Stage& stage, const Folder& folder) {
  Ladder ladder(stage, folder.path / "hints");
  std::string hint = ladder.next();
  ladder.remember();
  return hint;
}

std::string heading(const std::string& hint) { return hint.substr(0, hint.find('\n')); }

}  // namespace

TEST_CASE("every stage has a ladder, from a question to the formula and its slide", "[hint]") {
  for (const Stage& stage : stages) {
    INFO(stage.id);
    const auto& hints = stage_test(stage.id).hints;
    CHECK(hints.size() >= 5);
    CHECK_THAT(std::string(hints.front().en), ContainsSubstring("?"));
    CHECK_THAT(std::string(hints.front().el), ContainsSubstring(";"));
    int slides = 0;
    for (const Text& hint : hints) {
      CHECK(hint.en != hint.el);
      // No hint is code to paste.
      CHECK(hint.en.find(" = dot(") == std::string_view::npos);
      CHECK(hint.en.find("+=") == std::string_view::npos);
      slides += hint.el.find("Διαφάνει") != std::string_view::npos ||
                        hint.el.find("διαφάνει") != std::string_view::npos ||
                        hint.el.find("μάθημα 3") != std::string_view::npos
                    ? 1
                    : 0;
    }
    CHECK(slides >= 2);
  }
}

TEST_CASE("one more hint at each call; at the top the last one again", "[hint]") {
  const Folder folder;
  const Stage& stage = first_stage();
  const std::size_t count = stage_test(stage.id).hints.size();
  std::string before;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string hint = climb(stage, folder);
    CHECK(heading(hint) ==
          std::string(stage.id) + ": hint " + std::to_string(i) + " of " + std::to_string(count));
    CHECK(hint != before);
    CHECK((hint.find("--all") != std::string::npos) == (i == count));
    before = hint;
  }
  CHECK(climb(stage, folder) == before);

  SECTION("each stage has its own place") {
    const Stage& other = stages[1];
    CHECK_THAT(climb(other, folder), ContainsSubstring("hint 1 of "));
  }
  SECTION("all of them, which changes nothing") {
    Ladder ladder(stage, folder.path / "hints");
    for (std::size_t i = 1; i <= count; ++i) {
      CHECK_THAT(ladder.all(), ContainsSubstring("hint " + std::to_string(i) + " of "));
    }
    CHECK(climb(stage, folder) == before);
  }
  SECTION("forgotten") {
    Ladder(stage, folder.path / "hints").forget();
    CHECK_THAT(climb(stage, folder), ContainsSubstring("hint 1 of "));
  }
}

TEST_CASE("what is remembered may be damaged", "[hint]") {
  const Folder folder;
  const Stage& stage = first_stage();
  std::filesystem::create_directory(folder.path / "hints");
  const auto file = folder.path / "hints" / stage.id;
  for (const char* words : {"", "x", "-1", "99999999999999999999999", "2 hints"}) {
    std::ofstream(file) << words;
    const std::string expected = words[0] == '2' ? "hint 3 of " : "hint 1 of ";
    INFO(words);
    CHECK_THAT(climb(stage, folder), ContainsSubstring(expected));
  }
  std::ofstream(file) << "1000";
  CHECK_THAT(climb(stage, folder), ContainsSubstring("--all"));
  std::filesystem::remove_all(folder.path / "hints");
  std::ofstream(folder.path / "hints") << "not a folder";
  Ladder ladder(stage, folder.path / "hints");
  CHECK_FALSE(ladder.next().empty());
  CHECK_THROWS_AS(ladder.remember(), FileError);
}

TEST_CASE("the hints fit an 80-column terminal, in both languages", "[hint]") {
  const char* before = std::getenv("FOS_LANG");
  const std::string kept = before == nullptr ? "" : before;
  for (const char* language : {"en", "el"}) {
    setenv("FOS_LANG", language, 1);
    for (const Stage& stage : stages) {
      std::istringstream lines(Ladder(stage, "/nonexistent").all());
      for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(columns_of(line) <= terminal_width);
      }
    }
  }
  if (before == nullptr) {
    unsetenv("FOS_LANG");
  } else {
    setenv("FOS_LANG", kept.c_str(), 1);
  }
}
