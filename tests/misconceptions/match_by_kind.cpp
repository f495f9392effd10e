#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "explanation.hpp"
#include "match.hpp"

namespace fos {
namespace {

const Stage* stage_named(std::string_view id) {
  const auto* const found = std::find_if(std::begin(stages), std::end(stages),
                                         [&](const Stage& stage) { return stage.id == id; });
  return found == std::end(stages) ? nullptr : found;
}

/// Whether the frames with both kinds of lights are the sum of those with one kind each, less what
/// is in both, the ambient light and the background. All but those with ambient light alone are
/// whole.
bool adds_up(std::span<const Frame> frames, std::size_t scenes) {
  constexpr long double slack = 1e-3L;
  for (std::size_t i = 0; i < scenes; ++i) {
    const Frame& whole = frames[i];
    const Frame& ambient = frames[i + 3 * scenes];
    if (ambient.channels.size() != whole.channels.size()) return false;
    for (std::size_t k = 0; k < whole.channels.size(); ++k) {
      const long double point = frames[i + scenes].channels[k];
      const long double directional = frames[i + 2 * scenes].channels[k];
      const long double sum = point + directional - ambient.channels[k];
      const long double came = whole.channels[k];
      const bool cut_off = came >= 255 || point >= 255 || directional >= 255;
      if (!cut_off && !(std::abs(sum - came) <= slack * (1 + std::abs(came)))) return false;
    }
  }
  return true;
}

/// Where a mistake that shows in the lights of one kind only is made. What the catalogue has for
/// one kind alone says so itself; P and N are the same for both, so there it is no explanation.
std::optional<MistakeMade> only_in(const MistakeMade& finding, Where where) {
  const Misconception& mistake = misconception(finding.mistake);
  if (mistake.slot == Slot::P || mistake.slot == Slot::N || mistake.slot == Slot::call) return {};
  const bool for_one_kind =
      (mistake.stages & in_point) == 0 || (mistake.stages & in_directional) == 0;
  return MistakeMade{finding.mistake, for_one_kind ? Where::everywhere : where};
}

/// A mistake that both kinds of lights show is made everywhere. Nothing where it cannot be.
std::optional<Alternative> both(const Alternative& point, const Alternative& directional) {
  Alternative mistakes;
  const auto has = [](const Alternative& alternative, const MistakeMade& finding) {
    return std::find(alternative.begin(), alternative.end(), finding) != alternative.end();
  };
  for (const MistakeMade& finding : point) {
    const auto where = has(directional, finding) ? finding : only_in(finding, Where::point_lights);
    if (!where) return std::nullopt;
    mistakes.push_back(*where);
  }
  for (const MistakeMade& finding : directional) {
    if (has(point, finding)) continue;
    const auto where = only_in(finding, Where::directional_lights);
    if (!where) return std::nullopt;
    mistakes.push_back(*where);
  }
  return mistakes;
}

}  // namespace

std::vector<Alternative> match_by_kind(std::span<const Frame> frames) {
  const std::size_t scenes = base_scenes().size();
  const Stage* point = stage_named("point");
  const Stage* directional = stage_named("directional");
  if (frames.size() < 4 * scenes || point == nullptr || directional == nullptr) return {};
  if (!Evidence::of(frames)) return {};
  Match of_point = match(*point, frames.subspan(scenes, scenes));
  Match of_directional = match(*directional, frames.subspan(2 * scenes, scenes));
  if (!of_point.known() || !of_directional.known() || !adds_up(frames, scenes)) return {};
  if (of_point.right) of_point.alternatives = {{}};
  if (of_directional.right) of_directional.alternatives = {{}};
  std::vector<Alternative> alternatives;
  for (const Alternative& each : of_point.alternatives) {
    for (const Alternative& other : of_directional.alternatives) {
      if (auto mistakes = both(each, other)) alternatives.push_back(std::move(*mistakes));
    }
  }
  // A mistake in common explains more than two that only look alike.
  std::size_t least = SIZE_MAX;
  for (const Alternative& each : alternatives) least = std::min(least, each.size());
  std::erase_if(alternatives, [&](const Alternative& each) { return each.size() > least; });
  if (least == 0 || alternatives.size() > most_alternatives) return {};
  return alternatives;
}

}  // namespace fos
