// Numbers of a class.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "summary.hpp"

namespace fos::grading {

/// How a stage went.
struct StageStatistics {
  std::string stage;
  int most = 0;       ///< hundredths
  int all_right = 0;  ///< submissions with all of its points
  int partly = 0;     ///< with some
  int nothing = 0;    ///< with none
  int not_judged = 0;
  double mean = 0;  ///< hundredths, over those that are judged
};

/// A mistake by name, or, where none has a name, the kind of failure.
struct MistakeCount {
  std::string stage;
  std::string mistake;
  int submissions = 0;
};

struct ClassStatistics {
  int submissions = 0;
  int settled = 0;             ///< those with a final mark, of which the following tell
  int all_right = 0;           ///< with all points
  int most = 0;                ///< the largest that one is worth, hundredths
  std::optional<double> mean;  ///< hundredths
  std::optional<double> median;
  std::array<int, 10> tenths{};  ///< 0–10 %, …, 90–100 % of the points, the upper end in the last
  std::vector<StageStatistics> stages;  ///< in the order in which they come
  std::vector<MistakeCount> mistakes;   ///< the commonest first
};

ClassStatistics statistics_of(std::span<const Summary> all);

/// What has gone wrong in a stage: the mistake's name, else the kind; empty where nothing has, or
/// where it is no fault of the student's, or was charged in an earlier stage.
std::string trouble(const StageSummary& stage);

}  // namespace fos::grading
