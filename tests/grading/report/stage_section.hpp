// A stage on the page of a submission.
#pragma once

#include "markup_writer.hpp"
#include "report_words.hpp"
#include "result.hpp"

namespace fos::grading {

/// ✓ right, ✗ not right or – not judged, colored.
void add_status(MarkupWriter& out, const StageResult& stage);

/// What was checked and what came of it, the named mistake and the pictures, as far as `what` has
/// it told.
void add_stage_section(MarkupWriter& out, int number, const SubmissionResult& submission,
                       const StageResult& stage, const Shown& what);

}  // namespace fos::grading
