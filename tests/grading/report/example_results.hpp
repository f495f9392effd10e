// Results for the tests of the reports.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "result.hpp"

namespace fos::grading {

Run example_run();

/// All five stages right.
SubmissionResult right_submission();
/// A named mistake, one that is carried over, a stage that does not compile, one that crashes;
/// notes and an instructor's own mark.
SubmissionResult wrong_submission();
/// A stage that infrastructure kept from being judged.
SubmissionResult unjudged_submission();

/// A wrong submission whose every string is `text`, but for its id.
SubmissionResult hostile_submission(const std::string& text);
Run hostile_run(const std::string& text);

/// One of a class: of many names, every fourth of them hostile, with right, wrong and unjudged
/// ones.
SubmissionResult example_submission(int index);

/// What breaks out of some place: HTML, attributes, CSV, terminals, workflows, Markdown, JSON, XML.
const std::vector<std::string>& hostile_texts();

}  // namespace fos::grading
