// Right programs in other formulations are never named, nor are wrong ones that are not in the
// catalogue. FOS_RIGHT and FOS_WRONG are the programs of tests/check/variants.
#include <cstdlib>

#include "catch2.hpp"
#include "diagnosis.hpp"
#include "fos/stage_program.hpp"

using namespace fos;

namespace {

std::string letters(const Stage& stage) {
  if (stage.terms == 0) return "1";
  std::string all;
  if ((stage.terms & ambient_term) != 0) all += 'a';
  if ((stage.terms & point_term) != 0) all += 'p';
  if ((stage.terms & directional_term) != 0) all += 'd';
  return all;
}

/// What is diagnosed of a program that reads its name from a variable.
Diagnosis diagnose(const Stage& stage, const std::string& program, const char* variable,
                   const std::string& name) {
  setenv("FOS_TERMS", letters(stage).c_str(), 1);
  setenv(variable, name.c_str(), 1);
  std::vector<Frame> frames;
  for (const SceneText& scene : diagnostic_scenes(stage)) {
    StageProgram asked(program);  // a new one for each: a stage may keep statics
    REQUIRE(asked.ask(request_for(scene), frames.emplace_back()).ending == Ending::complete);
  }
  return diagnose(stage, frames);
}

}  // namespace

TEST_CASE("right programs have no name") {
  for (const Stage& stage : stages) {
    for (const std::string program : {FOS_RIGHT, FOS_RIGHT "_float"}) {
      for (const char* name :
           {"as_on_the_slides", "half_b", "geometric", "normalised_D", "normalised_D_simply",
            "factored_c", "stable_root", "fma", "max_with_0", "normalised_L", "sqrt_of_squares",
            "N_over_r", "N_not_normalised", "lights_backwards", "color_per_light", "clamped",
            "static_lights", "float_throughout"}) {
        INFO(stage.id << " " << name << " " << program);
        CHECK_FALSE(diagnose(stage, program, "FOS_FORMULATION", name).named());
      }
    }
  }
}

TEST_CASE("wrong programs that are not in the catalogue have no name") {
  for (const Stage& stage : stages) {
    for (const std::string program : {FOS_WRONG, FOS_WRONG "_float"}) {
      for (const char* name :
           {"none", "ambient_twice_alone", "lit_without_lights", "light_moved", "three_lights",
            "eight_spheres", "centre_behind_skipped", "whole_background", "t_min_nearly",
            "far_is_1000", "gamma", "a_percent_more", "hue_kept", "rounded", "not_a_number"}) {
        if (stage.terms == 0 && std::string(name) == "gamma") continue;
        const Diagnosis diagnosis = diagnose(stage, program, "FOS_MISTAKE", name);
        INFO(stage.id << " " << name << " " << program);
        for (const std::string& line : describe(diagnosis)) UNSCOPED_INFO(line);
        CHECK_FALSE(diagnosis.named());
      }
    }
  }
}

TEST_CASE("a mistake of a real program is named") {
  const Stage& stage = stages[2];
  const Diagnosis diagnosis = diagnose(stage, FOS_WRONG, "FOS_MISTAKE", "L_is_position");
  REQUIRE(diagnosis.certain.size() == 1);
  CHECK(diagnosis.certain[0].mistake == Mistake::L_is_position);
}
