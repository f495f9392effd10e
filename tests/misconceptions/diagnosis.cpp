#include "diagnosis.hpp"

#include <algorithm>

#include "match.hpp"

namespace fos {
namespace {

/// What all alternatives share is certain.
Diagnosis settle(std::vector<Alternative> alternatives) {
  Diagnosis diagnosis;
  if (alternatives.empty()) return diagnosis;
  const auto in_all = [&](const MistakeMade& finding) {
    return std::all_of(alternatives.begin(), alternatives.end(), [&](const Alternative& each) {
      return std::find(each.begin(), each.end(), finding) != each.end();
    });
  };
  for (const MistakeMade& finding : alternatives.front()) {
    if (in_all(finding)) diagnosis.certain.push_back(finding);
  }
  if (alternatives.size() == 1) return diagnosis;
  for (Alternative& each : alternatives) {
    std::erase_if(each, [&](const MistakeMade& finding) {
      return std::find(diagnosis.certain.begin(), diagnosis.certain.end(), finding) !=
             diagnosis.certain.end();
    });
  }
  diagnosis.one_of = std::move(alternatives);
  return diagnosis;
}

}  // namespace

Diagnosis diagnose(const Stage& stage, std::span<const Frame> frames) {
  const Match whole = match(stage, frames);
  if (whole.right || whole.too_many) return {};
  if (whole.known()) return settle(whole.alternatives);
  if (frames.size() > base_scenes().size()) return settle(match_by_kind(frames));
  return {};
}

}  // namespace fos
