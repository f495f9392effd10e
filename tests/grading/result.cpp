#include "result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace fos::grading {
namespace {

/// The override of a stage, or with an empty name of the whole; the last one counts.
const Override* override_of(const SubmissionResult& submission, std::string_view stage) {
  const auto found = std::find_if(submission.overrides.rbegin(), submission.overrides.rend(),
                                  [&](const Override& mine) { return mine.stage == stage; });
  return found == submission.overrides.rend() ? nullptr : &*found;
}

}  // namespace

int SubmissionResult::points() const {
  if (const Override* whole = override_of(*this, "")) return whole->points;
  int sum = 0;
  for (const StageResult& stage : stages) sum += points_of(*this, stage);
  return sum;
}

int SubmissionResult::most() const {
  int sum = 0;
  for (const StageResult& stage : stages) sum += stage.most;
  return sum;
}

int points_of(const SubmissionResult& submission, const StageResult& stage) {
  const Override* mine = override_of(submission, stage.stage);
  return mine != nullptr ? mine->points : stage.points;
}

std::string_view name(Status status) {
  switch (status) {
    case Status::passed:
      return "passed";
    case Status::failed:
      return "failed";
    case Status::not_judged:
      break;
  }
  return "not_judged";
}

std::string_view name(Cause cause) {
  switch (cause) {
    case Cause::none:
      return "none";
    case Cause::wrong_pixels:
      return "wrong_pixels";
    case Cause::not_finite:
      return "not_finite";
    case Cause::unwritten:
      return "unwritten";
    case Cause::crashed:
      return "crashed";
    case Cause::out_of_time:
      return "out_of_time";
    case Cause::out_of_memory:
      return "out_of_memory";
    case Cause::left:
      return "left";
    case Cause::refused:
      return "refused";
    case Cause::not_compiled:
      return "not_compiled";
    case Cause::no_file:
      return "no_file";
    case Cause::infrastructure:
      break;
  }
  return "infrastructure";
}

std::string_view name(Part part) {
  switch (part) {
    case Part::checks:
      return "checks";
    case Part::scenes:
      return "scenes";
    case Part::relations:
      break;
  }
  return "relations";
}

std::string_view name(Feedback feedback) {
  switch (feedback) {
    case Feedback::marks:
      return "marks";
    case Feedback::hints:
      return "hints";
    case Feedback::full:
      break;
  }
  return "full";
}

std::string points_text(int hundredths) {
  const long long whole = std::abs(static_cast<long long>(hundredths));
  std::string text = fmt::format("{}{}", hundredths < 0 ? "-" : "", whole / 100);
  const long long rest = whole % 100;
  if (rest != 0)
    text += rest % 10 == 0 ? fmt::format(".{}", rest / 10) : fmt::format(".{:02}", rest);
  return text;
}

}  // namespace fos::grading
