// From what a stage program answered to its points.
#pragma once

#include <vector>

#include "asked.hpp"
#include "diagnosis.hpp"
#include "result.hpp"
#include "stage_questions.hpp"

namespace fos::grading {

/// How a stage's points are shared out, in percent; together 100. labs/stages.json has them.
struct Shares {
  int checks = 0;
  int scenes = 0;
  int relations = 0;
};

/// What the answers for questions.scenes(), in that order, say of the public checks.
Findings examine_checks(const StageQuestions& questions, const std::vector<Asked>& answers);

/// Each line of the report and the points. `findings` are of the same answers. Nothing is taken for
/// granted: what did not come, or was not asked, gives no points.
StageResult score(const StageQuestions& questions, const Findings& findings,
                  const std::vector<Asked>& answers, const Shares& shares);

/// Counts again, taking for right what the mistakes make of each scene: for a stage whose mistakes
/// were all made, and paid for, in an earlier one. Sets `carried` where it gives more points.
void count_carried(StageResult& result, const StageQuestions& questions,
                   const std::vector<Asked>& answers, const Diagnosis& diagnosis,
                   const Shares& shares);

/// Why the answer is no frame, or a wrong one of which only that is known; Cause::none for a frame.
Cause cause_of(const Asked& asked);

}  // namespace fos::grading
