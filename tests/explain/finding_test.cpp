// Wrong programs, each of which goes wrong at a known line.
#include "finding.hpp"

#include <cstdlib>

#include "catch2.hpp"
#include "conclusion.hpp"
#include "scene_source.hpp"
#include "test_scenes.hpp"

using namespace fos;

namespace {

const Stage& stage_of(std::string_view id) {
  return *std::find_if(std::begin(stages), std::end(stages),
                       [&](const Stage& stage) { return stage.id == id; });
}

const char* letters_of(const Stage& stage) {
  switch (stage.terms) {
    case 0:
      return "1";
    case ambient_term:
      return "a";
    case ambient_term | point_term:
      return "ap";
    case ambient_term | directional_term:
      return "ad";
    default:
      return "apd";
  }
}

Comparison compare_with(const std::string& program, const SceneText& scene, const Stage& stage,
                        int column, int row) {
  const auto path = std::filesystem::path(FOS_PROGRAMS) / program;
  const Chain chain = certified_chain(scene, stage.terms, column, row);
  const RightAnswers right(scene, column, row);
  setenv("FOS_TERMS", letters_of(stage), 1);
  return compare(
      scene, stage, chain, right,
      [&](const SceneText& some) { return ask_alone(path, some, column, row, alone_limits); },
      [&](const SceneText& whole) {
        return ask_in_picture(path, whole, column, row, picture_limits);
      });
}

/// `line why`, with the light's number from 1.
std::string in_short(const std::optional<Difference>& difference) {
  if (!difference) return "right";
  static const char* const lines[] = {"sphere", "ambient", "light", "sum", "color"};
  static const char* const whys[] = {
      "different", "no_answer",    "not_finite",      "whole_numbers", "no_multiple", "plain",
      "not_alone", "behind",       "nothing",         "no_term",       "times_L",     "over_L",
      "times_r",   "other_sphere", "background_seen", "sphere_seen"};
  std::string out = lines[static_cast<int>(difference->line)];
  if (difference->line == Line::light) out += std::to_string(difference->light + 1);
  return out + " " + whys[static_cast<int>(difference->why)];
}

struct Case {
  const char* mistake;
  const char* expected;
};

void check_cases(const std::string& stage, const SceneText& scene, int column, int row,
                 const std::vector<Case>& cases) {
  for (const Case& each : cases) {
    INFO(each.mistake);
    setenv("FOS_MISTAKE", each.mistake, 1);
    const Comparison comparison =
        compare_with("variant_wrong", scene, stage_of(stage), column, row);
    CHECK(in_short(comparison.difference) == each.expected);
    CHECK(exit_status(comparison) == (each.expected == std::string_view("right") ? 0 : 1));
  }
}

}  // namespace

TEST_CASE("the first line that differs, on the lecture's red sphere") {
  check_cases("combined", lecture_scene(), 300, 349,
              {{"none", "right"},
               {"b_without_2", "sphere other_sphere"},
               {"without_4", "sphere other_sphere"},
               {"upside_down", "sphere background_seen"},
               {"ambient_forgotten", "ambient different"},
               {"ambient_twice", "ambient different"},
               {"ambient_twice_alone", "ambient different"},
               {"color_without_light", "ambient plain"},
               {"color_plus_I", "color no_multiple"},
               {"light_without_color", "color no_multiple"},
               {"a_percent_more", "ambient different"},
               {"L_not_normalised", "light2 times_L"},
               {"divided_by_L_squared", "light2 over_L"},
               {"cosine_squared", "light2 different"},
               {"all_or_nothing", "light2 different"},
               {"L_is_position", "light2 different"},
               {"light_moved", "light2 different"},
               {"L_reversed", "light2 nothing"},
               {"N_inward", "light2 nothing"},
               {"truncated", "light2 whole_numbers"},
               {"rounded", "light2 whole_numbers"},
               {"direction_negated", "light3 nothing"},
               {"directional_forgotten", "light3 nothing"},
               {"not_a_number", "light3 not_finite"},
               {"last_light_only", "sum different"},
               {"first_light_only", "sum different"},
               {"brightest_light", "sum different"},
               {"ambient_per_light", "sum different"},
               // These show elsewhere, not here.
               {"P_without_O", "right"},
               {"absolute_cosine", "right"},
               {"N_not_normalised", "right"}});
}

TEST_CASE("the first line that differs, among many lights, off the origin") {
  check_cases("combined", test_scene("many_lights"), 20, 30,
              {{"none", "right"},
               {"N_not_normalised", "light1 times_r"},
               {"P_without_O", "light1 nothing"},
               {"absolute_cosine", "light7 behind"},
               {"negative_kept", "light7 behind"},
               {"direction_is_position", "light2 different"},
               {"channels_swapped", "color no_multiple"},
               {"truncated", "ambient whole_numbers"},
               {"cut_off_at_1", "sum different"},
               {"hue_kept", "sum different"},
               {"three_lights", "sum different"}});
  // A light that is no term of the stage: the program sums up more than it should.
  setenv("FOS_MISTAKE", "none", 1);
  const Stage& stage = stage_of("point");
  Stage brighter = stage;
  brighter.terms = ambient_term;  // what is right; the program has the point lights too
  const SceneText scene = test_scene("many_lights");
  const Chain chain = certified_chain(scene, brighter.terms, 20, 30);
  const RightAnswers right(scene, 20, 30);
  setenv("FOS_TERMS", "ap", 1);
  const auto path = std::filesystem::path(FOS_PROGRAMS) / "variant_wrong";
  const Comparison comparison = compare(
      scene, brighter, chain, right,
      [&](const SceneText& some) { return ask_alone(path, some, 20, 30, alone_limits); },
      [&](const SceneText& whole) { return ask_in_picture(path, whole, 20, 30, picture_limits); });
  CHECK(in_short(comparison.difference) == "light1 no_term");
}

TEST_CASE("the first line that differs, without light and at the background") {
  check_cases("flat_color", test_scene("tangent"), 24, 19,
              {{"none", "right"},
               {"tangent_misses", "sphere other_sphere"},
               {"last_sphere", "sphere other_sphere"},
               {"b_without_2", "sphere background_seen"}});
  check_cases("flat_color", test_scene("ties"), 40, 24,
              {{"none", "right"}, {"last_of_equals", "sphere other_sphere"}});
  check_cases("combined", lecture_scene(), 300, 10,
              {{"none", "right"},
               {"black_background", "color different"},
               {"upside_down", "sphere sphere_seen"}});
  check_cases("flat_color", test_scene("near_plane"), 33, 25,
              {{"none", "right"}, {"t_min_ignored", "sphere other_sphere"}});
}

TEST_CASE("either sphere is right where rounding decides") {
  setenv("FOS_MISTAKE", "tangent_misses", 1);
  const Comparison comparison =
      compare_with("variant_wrong", lecture_scene(), stage_of("flat_color"), 300, 299);
  CHECK_FALSE(comparison.difference.has_value());
  CHECK(comparison.sphere == 0);
  CHECK(comparison.whole().expected.size() == 2);
}

TEST_CASE("right programs in other formulations are right at every line") {
  for (const char* formulation :
       {"as_on_the_slides", "half_b", "geometric", "normalised_D", "stable_root", "max_with_0",
        "N_over_r", "N_not_normalised", "lights_backwards", "color_per_light", "clamped",
        "static_lights", "float_throughout"}) {
    INFO(formulation);
    setenv("FOS_FORMULATION", formulation, 1);
    for (const char* program : {"variant_right", "variant_right_float"}) {
      INFO(program);
      for (const char* name : {"many_lights", "light_on_surface"}) {
        const SceneText scene = test_scene(name);
        INFO(name);
        for_some_pixels(scene, 2, [&](int column, int row) {
          INFO("column " << column << ", row " << row);
          const Comparison comparison =
              compare_with(program, scene, stage_of("combined"), column, row);
          CHECK(in_short(comparison.difference) == "right");
          CHECK_FALSE(comparison.depends);
        });
      }
    }
  }
}

TEST_CASE("no answer, and answers that hang on something else") {
  const auto odd = [](const char* name, const char* stage) {
    setenv("FOS_ODD", name, 1);
    return compare_with("odd_stage", lecture_scene(), stage_of(stage), 300, 349);
  };
  const auto ending = [](const Comparison& comparison) {
    return comparison.alone.given.answer.ending;
  };
  CHECK(ending(odd("crashes", "flat_color")) == Ending::crashed);
  CHECK(ending(odd("exits", "flat_color")) == Ending::exited);
  CHECK(ending(odd("throws", "flat_color")) == Ending::exited);
  CHECK(ending(odd("never ends", "flat_color")) == Ending::timed_out);
  CHECK_FALSE(odd("unwritten", "flat_color").answered());

  const Comparison crash = odd("crashes later", "flat_color");
  CHECK(crash.answered());
  CHECK(crash.in_picture->given.answer.ending == Ending::crashed);
  CHECK(crash.in_picture->given.answer.rows == 1);
  CHECK_FALSE(crash.difference.has_value());
  CHECK(exit_status(crash) == 1);

  // Nothing after the pixel's row is waited for.
  setenv("FOS_ODD", "crashes later", 1);
  const Comparison first_row =
      compare_with("odd_stage", lecture_scene(), stage_of("flat_color"), 300, 0);
  CHECK(first_row.in_picture->given.came());

  const Comparison counts = odd("counts", "flat_color");
  CHECK(counts.depends);
  CHECK(in_short(counts.difference) == "color not_alone");

  CHECK(in_short(odd("lit", "point").difference) == "right");
  CHECK(in_short(odd("crashes in one light", "point").difference) == "light2 no_answer");

  const Comparison none =
      compare_with("no such program", lecture_scene(), stage_of("point"), 300, 349);
  CHECK(ending(none) == Ending::did_not_start);
  CHECK(exit_status(none) == 3);
}
