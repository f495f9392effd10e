// A whole class: several graders at work, a journal, and the reports at the end.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "grade_options.hpp"
#include "grading/intake/class_files.hpp"
#include "grading/intake/journal.hpp"
#include "grading/report/report_files.hpp"
#include "submission_grader.hpp"

namespace fos::grading {

/// How a run has gone.
struct Tally {
  std::size_t finished_before = 0;  ///< found in the journal
  std::size_t graded = 0;
  std::size_t not_judged = 0;  ///< by trouble of ours
};

/// Thrown by what waits when the run is to end early (Ctrl-C).
struct Interrupted {};

/// Grades what the journal does not have yet. Each result is on the disk as soon as it is there, so
/// a run that ends early loses only what is at hand. Throws Interrupted soon after `stop` is set,
/// and FileError where results cannot be written any more.
Tally grade_class(const ClassFiles& hand_ins, const std::vector<std::string>& keys,
                  const Course& course, Journal& journal, const GradeOptions& options,
                  const std::atomic<bool>& stop);

}  // namespace fos::grading
