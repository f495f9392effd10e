#include "class_statistics.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "report_words.hpp"

namespace fos::grading {
namespace {

StageStatistics& of_stage(std::vector<StageStatistics>& list, const std::string& id) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const StageStatistics& one) { return one.stage == id; });
  if (found != list.end()) return *found;
  list.push_back({});
  list.back().stage = id;
  return list.back();
}

void count_stage(std::vector<StageStatistics>& list, const StageSummary& stage) {
  StageStatistics& one = of_stage(list, stage.stage);
  one.most = std::max(one.most, stage.most);
  if (stage.status == Status::not_judged) {
    ++one.not_judged;
    return;
  }
  ++(stage.points >= stage.most ? one.all_right : stage.points > 0 ? one.partly : one.nothing);
  one.mean += stage.points;  // a sum until all are counted
}

double median_of(std::vector<int> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

}  // namespace

std::string trouble(const StageSummary& stage) {
  if (stage.status != Status::failed || stage.carried) return "";
  return stage.mistake.empty() ? cause_words(stage.cause) : stage.mistake;
}

ClassStatistics statistics_of(std::span<const Summary> all) {
  ClassStatistics out;
  out.submissions = static_cast<int>(all.size());
  std::map<std::pair<std::string, std::string>, int> mistakes;
  std::vector<int> marks;
  for (const Summary& one : all) {
    out.most = std::max(out.most, one.most);
    for (const StageSummary& stage : one.stages) {
      count_stage(out.stages, stage);
      if (const std::string words = trouble(stage); !words.empty()) {
        ++mistakes[{stage.stage, words}];
      }
    }
    if (!is_settled(one)) continue;
    marks.push_back(one.points);
    if (one.points >= one.most) ++out.all_right;
    const long tenth = one.most > 0 ? one.points * 10L / one.most : 0;
    ++out.tenths[static_cast<std::size_t>(std::clamp(tenth, 0L, 9L))];
  }
  for (StageStatistics& stage : out.stages) {
    const int judged = stage.all_right + stage.partly + stage.nothing;
    if (judged > 0) stage.mean /= judged;
  }
  out.settled = static_cast<int>(marks.size());
  if (!marks.empty()) {
    out.mean = std::accumulate(marks.begin(), marks.end(), 0.0) / static_cast<double>(marks.size());
    out.median = median_of(marks);
  }
  for (const auto& [key, count] : mistakes) out.mistakes.push_back({key.first, key.second, count});
  std::stable_sort(
      out.mistakes.begin(), out.mistakes.end(),
      [](const MistakeCount& a, const MistakeCount& b) { return a.submissions > b.submissions; });
  return out;
}

}  // namespace fos::grading
