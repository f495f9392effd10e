// Which mistake makes exactly this picture: a failing stage's frames against what each mistake of
// the catalogue, and each pair of them, gives on the diagnostic scenes.
//
//   const auto scenes = fos::diagnostic_scenes(stage);       // ask the stage program for each
//   const fos::Diagnosis diagnosis = fos::diagnose(stage, frames);
//   for (const std::string& line : fos::describe(diagnosis)) …
//
// Nothing is guessed: a mistake is named when it explains every pixel that is compared, to about a
// quarter of a percent of its light, and nothing else does as well.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnostic_scenes.hpp"
#include "fos/frame.hpp"
#include "fos/stage_list.hpp"
#include "mistakes.hpp"

namespace fos {

/// Where a mistake is made, in a stage that has both kinds of lights.
enum class Where { everywhere, point_lights, directional_lights };

struct MistakeMade {
  Mistake mistake;
  Where where = Where::everywhere;
  bool operator==(const MistakeMade&) const = default;
};

/// What was found. Nothing: the frames are right on these scenes, or unwritten or not finite
/// somewhere, or nothing in the catalogue explains them.
struct Diagnosis {
  /// These are made, all of them.
  std::vector<MistakeMade> certain;
  /// And one of these, which no scene can tell apart: each a mistake, or two that go together.
  /// Empty, or 2 or 3 of them.
  std::vector<std::vector<MistakeMade>> one_of;

  bool named() const { return !certain.empty() || !one_of.empty(); }
};

/// `frames` are a stage program's, of any precision, for diagnostic_scenes(stage), in that order;
/// one that did not come is an empty Frame. The base scenes must all be there for anything to be
/// named. Throws MistakeDataError where the data are missing or of other scenes.
Diagnosis diagnose(const Stage& stage, std::span<const Frame> frames);

/// A diagnosis in words, in the language of this process: for each mistake its name, the question
/// and where to look, a line each, the last two indented. Empty where nothing is named.
std::vector<std::string> describe(const Diagnosis& diagnosis);

/// The questions and where to look, without the names: for who is to find the mistake's name alone.
std::vector<std::string> questions(const Diagnosis& diagnosis);

/// The names alone, in one line; empty where nothing is named.
std::string names(const Diagnosis& diagnosis);

}  // namespace fos
