#include "summary.hpp"

#include <algorithm>

#include "clean_text.hpp"

namespace fos::grading {
namespace {

Cause main_cause(const StageResult& stage) {
  if (stage.cause != Cause::none) return stage.cause;
  for (const CheckResult& check : stage.checks) {
    if (check.status == Status::failed && check.cause != Cause::none) return check.cause;
  }
  return Cause::none;
}

bool is_marked(const Summary& summary, std::string_view stage) {
  return std::any_of(summary.overrides.begin(), summary.overrides.end(),
                     [&](const Override& own) { return own.stage == stage; });
}

}  // namespace

Summary summarize(const SubmissionResult& submission) {
  Summary out;
  out.id = submission.id;
  out.name = submission.name;
  out.username = submission.username;
  out.email = submission.email;
  out.status = submission.status;
  out.points = submission.points();
  out.most = submission.most();
  out.overrides = submission.overrides;
  out.notes = static_cast<int>(submission.notes.size());
  for (const StageResult& stage : submission.stages) {
    out.stages.push_back({stage.stage, stage.status, main_cause(stage),
                          points_of(submission, stage), stage.most, shortened(stage.mistake, 300),
                          stage.carried});
  }
  return out;
}

bool is_settled(const Summary& summary) {
  if (summary.status != Status::not_judged || is_marked(summary, "")) return true;
  // A stage that was not asked for has no points to give, and keeps no mark back.
  return !summary.stages.empty() &&
         std::all_of(summary.stages.begin(), summary.stages.end(), [&](const StageSummary& stage) {
           return stage.status != Status::not_judged || is_marked(summary, stage.stage);
         });
}

}  // namespace fos::grading
