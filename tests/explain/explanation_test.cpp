// The words of an explanation, in both languages.
#include "explanation.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "catch2.hpp"
#include "layout.hpp"
#include "page.hpp"
#include "test_scenes.hpp"

using namespace fos;

namespace {

const Stage& stage_of(std::string_view id) {
  return *std::find_if(std::begin(stages), std::end(stages),
                       [&](const Stage& stage) { return stage.id == id; });
}

Explanation explained(const SceneText& scene, const char* stage, int column, int row,
                      const char* program = nullptr) {
  std::optional<std::filesystem::path> path;
  if (program != nullptr) path = std::filesystem::path(FOS_PROGRAMS) / program;
  return explain({scene, stage_of(stage), column, row}, path, false);
}

/// Of `variant_wrong` with a mistake, at all terms.
Explanation mistaken(const char* mistake, const SceneText& scene, int column, int row) {
  setenv("FOS_MISTAKE", mistake, 1);
  setenv("FOS_TERMS", "apd", 1);
  return explained(scene, "combined", column, row, "variant_wrong");
}

Explanation odd(const char* name, const char* stage = "flat_color") {
  setenv("FOS_ODD", name, 1);
  return explained(lecture_scene(), stage, 300, 349, "odd_stage");
}

int count(const std::string& text, std::string_view part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

void check_width(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(columns_of(line) <= 80);
    CHECK_FALSE(line.ends_with(' '));
  }
}

}  // namespace

TEST_CASE("what is right, without a program") {
  setenv("FOS_LANG", "en", 1);
  const Explanation explanation = explained(lecture_scene(), "combined", 300, 349);
  CHECK(explanation.status == 0);
  for (const char* part :
       {"(0, -0.08333333, 1)", "2.4   t1, t2  <- nearest: t2", "(0, 0.8, -0.6)", "3.346640",
        "0.7171372  (44.18°)", "0.4302823", "0.6581347", "168 0 0", "does not build"}) {
    CHECK_THAT(explanation.text, ContainsSubstring(part));
  }
  CHECK(count(explanation.text, "✓") + count(explanation.text, "✗") == 0);
}

TEST_CASE("yours is right, line by line") {
  setenv("FOS_LANG", "en", 1);
  const Explanation explanation = mistaken("none", lecture_scene(), 300, 349);
  CHECK(explanation.status == 0);
  CHECK(count(explanation.text, "✓") == 7);  // sphere, I_A, two terms, I, color, byte
  CHECK(count(explanation.text, "✗") == 0);
  CHECK_THAT(explanation.text, ContainsSubstring("Yours is right here, line by line."));
}

TEST_CASE("it stops at the first line that differs") {
  setenv("FOS_LANG", "en", 1);
  const Explanation explanation = mistaken("cosine_squared", lecture_scene(), 300, 349);
  CHECK(explanation.status == 1);
  CHECK(count(explanation.text, "✓") == 2);
  CHECK(count(explanation.text, "✗") == 1);
  CHECK_THAT(explanation.text,
             ContainsSubstring("Your term for light 2 is 0.3085714 where 0.4302823 is right."));
  CHECK_THAT(explanation.text, !ContainsSubstring("light 3"));
  CHECK_THAT(explanation.text, !ContainsSubstring("byte"));
  CHECK_THAT(explanation.text, ContainsSubstring("┴"));
}

TEST_CASE("where the numbers look the same, more digits tell them apart") {
  setenv("FOS_LANG", "en", 1);
  // 255 * 0.2 and a hair: wrong in double, the same in seven digits.
  SceneText scene = parse_scene_text(
      "canvas_size = 2 x 2\nsphere { center = (0, 0, 3) radius = 1 color = (200, 100, 0) }\n"
      "light { type = ambient intensity = 1e-5 }\n"
      "light { type = directional intensity = 1 direction = (0, 0, -1) }\n",
      "scene");
  const Explanation explanation = mistaken("brightest_light", scene, 1, 0);
  CHECK_THAT(explanation.text, ContainsSubstring("1.00001"));
  CHECK(explanation.status == 1);
}

TEST_CASE("background, tangent and many spheres are said in words") {
  setenv("FOS_LANG", "en", 1);
  const Explanation sky = mistaken("none", lecture_scene(), 300, 10);
  CHECK(sky.status == 0);
  CHECK_THAT(sky.text, ContainsSubstring("the ray meets nothing"));
  const Explanation tangent = mistaken("none", lecture_scene(), 300, 299);
  CHECK_THAT(tangent.text, ContainsSubstring("touches sphere 1 in one point"));
  CHECK_THAT(tangent.text, ContainsSubstring("rounding decides"));
  const Explanation crowd = mistaken("none", test_scene("crowd"), 10, 20);
  CHECK_THAT(crowd.text, ContainsSubstring("more that are missed"));
  const Explanation black =
      mistaken("L_not_normalised",
               parse_scene_text("canvas_size = 2 x 2\n"
                                "sphere { center = (0, 0, 3) radius = 1 color = (0, 0, 0) }\n"
                                "light { type = point intensity = 1 position = (0, 0, 0) }\n",
                                "scene"),
               1, 0);
  CHECK(black.status == 0);
  CHECK_THAT(black.text, ContainsSubstring("no light shows on it"));
  const Explanation ahead = mistaken("none", test_scene("light_on_surface"), 24, 17);
  CHECK_THAT(ahead.text, ContainsSubstring("the light is at P"));
}

TEST_CASE("no answer is said as what it is") {
  setenv("FOS_LANG", "en", 1);
  CHECK_THAT(odd("unwritten").text, ContainsSubstring("not written yet"));
  CHECK_THAT(odd("crashes").text, ContainsSubstring("crashes (Segmentation fault)"));
  CHECK_THAT(odd("never ends").text, ContainsSubstring("(stopped after 2 s)"));
  CHECK_THAT(odd("exits").text, ContainsSubstring("exit status 3"));
  const Explanation thrown = odd("throws");
  CHECK_THAT(thrown.text, ContainsSubstring("exit status 1"));
  CHECK_THAT(thrown.words, ContainsSubstring("no such thing"));
  CHECK_THAT(odd("crashes later").text, ContainsSubstring("after 1 rows"));
  CHECK_THAT(odd("exits later").text, ContainsSubstring("ends by itself after 1 rows"));
  CHECK_THAT(odd("counts").text, ContainsSubstring("depends on more than O, D and the scene"));
  CHECK_THAT(odd("crashes in one light", "point").text,
             ContainsSubstring("With light 2 alone your program gives no answer"));
  for (const char* name :
       {"unwritten", "crashes", "exits", "throws", "crashes later", "exits later", "counts"}) {
    INFO(name);
    CHECK(odd(name).status == 1);
  }
}

TEST_CASE("a picture that takes too long is no mistake at this pixel") {
  setenv("FOS_LANG", "en", 1);
  const Explanation explanation = odd("never ends later");
  CHECK(explanation.status == 0);
  CHECK_THAT(explanation.text, ContainsSubstring("had not come to this row"));
}

TEST_CASE("what a stage prints is kept out of the explanation") {
  // The test's own standard output, for a moment a file.
  std::cout.flush();
  std::FILE* file = std::tmpfile();
  const int real = dup(STDOUT_FILENO);
  dup2(fileno(file), STDOUT_FILENO);
  const Explanation explanation = odd("prints");
  dup2(real, STDOUT_FILENO);
  close(real);
  const long printed = lseek(fileno(file), 0, SEEK_END);
  std::fclose(file);
  CHECK(printed == 0);
  CHECK(explanation.status == 0);
  CHECK_THAT(explanation.words, ContainsSubstring("to cerr"));
  CHECK_THAT(explanation.words, !ContainsSubstring("to cout"));
}

TEST_CASE("every line fits 80 columns, in both languages") {
  for (const char* language : {"en", "el"}) {
    setenv("FOS_LANG", language, 1);
    for (const SceneText& scene : all_scenes()) {
      INFO(scene.name);
      for_some_pixels(scene, 2, [&](int column, int row) {
        check_width(mistaken("none", scene, column, row).text);
      });
    }
    for (const char* mistake :
         {"without_4", "upside_down", "ambient_twice", "color_plus_I", "color_without_light",
          "L_not_normalised", "divided_by_L_squared", "N_not_normalised", "light_moved",
          "L_reversed", "absolute_cosine", "truncated", "not_a_number", "last_light_only"}) {
      INFO(mistake);
      check_width(mistaken(mistake, test_scene("many_lights"), 20, 30).text);
    }
    for (const char* name : {"unwritten", "crashes", "exits", "crashes later", "counts"}) {
      check_width(odd(name).text);
    }
  }
}

TEST_CASE("colors only where they are asked for") {
  const SceneText scene = lecture_scene();
  const auto text = [&](bool colors) {
    setenv("FOS_MISTAKE", "cosine_squared", 1);
    setenv("FOS_TERMS", "apd", 1);
    return explain({scene, stage_of("combined"), 300, 349},
                   std::filesystem::path(FOS_PROGRAMS) / "variant_wrong", colors)
        .text;
  };
  CHECK(count(text(false), "\033") == 0);
  CHECK(count(text(true), "\033[31m✗\033[0m") == 1);
  CHECK(count(text(true), "\033[32m✓\033[0m") == 2);
}
