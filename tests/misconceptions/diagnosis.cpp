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

/// Whether a kind of lights that is said to be left out shows where the other kind is not there.
bool is_contradicted(const Alternative& mistakes, std::span<const Frame> frames) {
  const std::size_t count = base_scenes().size();
  if (frames.size() < 4 * count) return false;
  const auto shows = [&](std::size_t part) {  // of diagnostic_scenes(); the last has no lights
    for (std::size_t i = 0; i < count; ++i) {
      const auto& lit = frames[part * count + i].channels;
      const auto& dark = frames[3 * count + i].channels;
      if (!lit.empty() && !dark.empty() && lit != dark) return true;
    }
    return false;
  };
  const bool point = shows(1);
  const bool directional = shows(2);
  return std::ranges::any_of(mistakes, [&](const MistakeMade& made) {
    return (point && made.mistake == Mistake::point_forgotten) ||
           (directional && made.mistake == Mistake::directional_forgotten) ||
           ((point || directional) && made.mistake == Mistake::lights_forgotten);
  });
}

}  // namespace

Diagnosis diagnose(const Stage& stage, std::span<const Frame> frames) {
  const Match whole = match(stage, frames);
  if (whole.right || whole.too_many) return {};
  if (whole.known()) {
    std::vector<Alternative> alternatives = whole.alternatives;
    std::erase_if(alternatives,
                  [&](const Alternative& each) { return is_contradicted(each, frames); });
    return settle(std::move(alternatives));
  }
  if (frames.size() > base_scenes().size()) return settle(match_by_kind(frames));
  return {};
}

}  // namespace fos
