// A whole class: several graders at work, a journal, and the reports at the end.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "grade_options.hpp"
#include "grading/intake/intake.hpp"
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

/// What is known of one hand-in besides its files.
struct Entry {
  Whose whose;  ///< with what a roster says
  std::string key;
  std::vector<Override> overrides;
  std::size_t place = 0;  ///< of the hand-in in the class
};

/// Puts what is known of a hand-in into its result; whether that changes it.
bool complete(SubmissionResult& result, const Entry& entry);

/// Whether the journal has them all.
bool all_finished(const std::vector<Entry>& entries, const Journal& journal);

/// Of all entries, those that were graded before too: their pages where a roster or an override has
/// changed them, and the files of the class. What platforms would refuse, in words.
std::vector<std::string> report_class(const GradeOptions& options, const Run& run,
                                      const std::vector<Entry>& entries, Journal& journal);

/// Grades what of the entries the journal does not have yet. Each result is
/// on the disk as soon as it is there, with its pages, so a run that ends early loses only what is
/// at hand. Throws Interrupted soon after `stop` is set, and FileError where results cannot be
/// written any more.
class ClassRun {
 public:
  ClassRun(const Course& course, const GradeOptions& options, const Run& run,
           std::filesystem::path scratch)
      : course_(course), options_(options), run_(run), scratch_(std::move(scratch)) {}

  Tally grade(const ClassFiles& hand_ins, const std::vector<Entry>& entries, Journal& journal,
              const std::atomic<bool>& stop) const;

 private:
  const Course& course_;
  const GradeOptions& options_;
  const Run& run_;
  std::filesystem::path scratch_;
};

}  // namespace fos::grading
