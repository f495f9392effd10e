// What the page and the files of a whole class need of each submission: little enough to hold
// thousands in memory.
#pragma once

#include <string>
#include <vector>

#include "result.hpp"

namespace fos::grading {

struct StageSummary {
  std::string stage;  ///< its id
  Status status = Status::not_judged;
  Cause cause = Cause::none;  ///< of the stage, or, where its checks alone have one, of the first
  int points = 0;             ///< hundredths, with the override
  int most = 0;
  std::string mistake;  ///< at most 300 characters
  bool carried = false;
};

struct Summary {
  std::string id;
  std::string name;
  std::string username;
  std::string email;
  Status status = Status::not_judged;
  int points = 0;  ///< hundredths, with the overrides
  int most = 0;
  std::vector<StageSummary> stages;
  std::vector<Override> overrides;
  int notes = 0;  ///< how many there are of the hand-in
};

Summary summarize(const SubmissionResult& submission);

/// Whether there is a mark that can be given: everything has been judged, or an instructor has
/// marked the whole of it, or each stage that could not be judged.
bool is_settled(const Summary& summary);

}  // namespace fos::grading
