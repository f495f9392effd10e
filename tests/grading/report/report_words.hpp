// What reports say of a result, in the language of this process, unescaped.
#pragma once

#include <string>
#include <string_view>

#include "result.hpp"
#include "summary.hpp"

namespace fos::grading {

/// What a student is told, by what the instructor chose.
struct Shown {
  bool question = false;  ///< hints: the question that leads to the mistake, and where to look
  bool mistake = false;   ///< full: its name
  bool why = false;       ///< full: the first wrong pixel, what was expected there and what came
  bool pictures = false;  ///< full: yours, expected, difference
};
Shown shown(Feedback feedback);

/// The stage's name, from the list of stages; its id where it is not there.
std::string stage_title(std::string_view id);

std::string part_title(Part part);
std::string cause_words(Cause cause);  ///< empty for `none`
std::string status_words(Status status);
/// ✓, ✗ or –.
std::string_view mark(Status status);

/// What all was graded with: the date, the toolkit, the seed and the level of the box, in one line.
std::string graded_with(const Run& run, std::uint64_t seed, std::string_view box);

/// How the programs were kept apart: the level of the box.
std::string box_words(std::string_view box);

/// "22.5 / 30".
std::string points_of_most(int points, int most);

/// What is checked.
std::string check_title(const CheckResult& check);
/// The same with how many of how many, where that is more than one and not all of them.
std::string check_words(const CheckResult& check);
/// Why it has not passed: the first wrong pixel where it may be told, else the kind of failure, if
/// that is not said of the whole stage already, or plain from ✗.
std::string check_why(const StageResult& stage, const CheckResult& check, const Shown& what);

/// Said where nobody could judge, or a mistake is not charged here: the stage's notes, in lines.
std::string stage_notes(const StageResult& stage);

/// The lines of a stage, as plain text: every check with its mark and why, then what is said of the
/// mistake and what the compiler said.
std::string stage_text(const StageResult& stage, const Shown& what);

/// An override in words, with its reason.
std::string override_words(const Override& own);

/// A platform's comment: one line that begins with a letter, the points of every stage and, as far
/// as the instructor wants it told, the mistakes; the instructor's own marks with their reasons.
std::string comment(Feedback feedback, const Summary& summary);

}  // namespace fos::grading
