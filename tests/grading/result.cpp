#include "result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace fos::grading {
namespace {

const Override* override_of(const SubmissionResult& submission, std::string_view stage) {
  const Override* found = nullptr;
  for (const Override& one : submission.overrides) {
    if (one.stage == stage) found = &one;
  }
  return found;
}

}  // namespace

int points_of(const SubmissionResult& submission, const StageResult& stage) {
  const Override* own = override_of(submission, stage.stage);
  return own != nullptr ? own->points : stage.points;
}

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
  constexpr std::string_view names[] = {
      "none",          "wrong_pixels", "not_finite", "unwritten",    "crashed", "out_of_time",
      "out_of_memory", "left",         "refused",    "not_compiled", "no_file", "infrastructure"};
  return names[static_cast<std::size_t>(cause)];
}

std::string_view name(Part part) {
  constexpr std::string_view names[] = {"checks", "scenes", "relations"};
  return names[static_cast<std::size_t>(part)];
}

std::string_view name(Feedback feedback) {
  constexpr std::string_view names[] = {"marks", "hints", "full"};
  return names[static_cast<std::size_t>(feedback)];
}

std::string points_text(int hundredths) {
  const int size = std::abs(hundredths);
  std::string text = fmt::format("{}{}", hundredths < 0 ? "-" : "", size / 100);
  if (size % 100 == 0) return text;
  text += fmt::format(".{:02}", size % 100);
  if (text.back() == '0') text.pop_back();
  return text;
}

}  // namespace fos::grading
