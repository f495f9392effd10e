#include "diagnosis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include "explanation.hpp"

namespace fos {
namespace {

/// More alternatives than this say nothing.
constexpr std::size_t most_alternatives = 3;

using Alternative = std::vector<Finding>;

std::vector<Mistake> finishing(const Stage& stage) {
  std::vector<Mistake> mistakes;
  for (const Misconception& each : misconceptions()) {
    const bool finishes = each.slot == Slot::ending || each.slot == Slot::background;
    if (finishes && (each.stages & stage_bit(stage.id)) != 0) mistakes.push_back(each.mistake);
  }
  return mistakes;
}

/// What at most `more` finishing mistakes can be, each of another slot.
std::vector<MistakeSet> finishes(const Stage& stage, std::size_t more) {
  std::vector<MistakeSet> sets{{}};
  const std::vector<Mistake> mistakes = finishing(stage);
  for (std::size_t i = 0; i < mistakes.size() && more >= 1; ++i) {
    sets.push_back({mistakes[i]});
    for (std::size_t j = i + 1; j < mistakes.size() && more >= 2; ++j) {
      if (misconception(mistakes[i]).slot != misconception(mistakes[j]).slot) {
        sets.push_back({mistakes[i], mistakes[j]});
      }
    }
  }
  return sets;
}

Alternative alternative(const Plane& plane, const MistakeSet& finish) {
  Alternative mistakes;
  if (plane.first) mistakes.push_back({*plane.first});
  if (plane.second) mistakes.push_back({*plane.second});
  for (const Mistake mistake : finish.list()) mistakes.push_back({mistake});
  return mistakes;
}

/// What explains the frames of the base scenes with the fewest mistakes.
struct Match {
  bool right = false;
  bool too_many = false;  ///< so many that they say nothing
  std::vector<Alternative> alternatives;
  bool known() const { return right || !alternatives.empty(); }
};

Match match(const Stage& stage, std::span<const Frame> frames) {
  const auto evidence = Evidence::of(frames);
  if (!evidence) return {};
  const StageMistakes& data = mistakes_of(stage);
  const Explainer explainer(data);
  Match match;
  const auto made = [](const Plane& plane) {
    return static_cast<std::size_t>(plane.first.has_value()) +
           static_cast<std::size_t>(plane.second.has_value());
  };
  for (std::size_t count = 0; count <= 2 && !match.known(); ++count) {
    for (const Plane& plane : data.planes) {
      if (made(plane) > count) continue;
      for (const MistakeSet& finish : finishes(stage, count - made(plane))) {
        if (made(plane) + finish.list().size() != count) continue;
        if (!explainer.explains(plane, finish, *evidence)) continue;
        if (count == 0) {
          match.right = true;
        } else {
          match.alternatives.push_back(alternative(plane, finish));
        }
      }
    }
  }
  match.too_many = match.alternatives.size() > most_alternatives;
  if (match.too_many) match.alternatives.clear();
  return match;
}

/// What all alternatives share is certain.
Diagnosis settle(std::vector<Alternative> alternatives) {
  Diagnosis diagnosis;
  if (alternatives.empty()) return diagnosis;
  const auto in_all = [&](const Finding& finding) {
    return std::all_of(alternatives.begin(), alternatives.end(), [&](const Alternative& each) {
      return std::find(each.begin(), each.end(), finding) != each.end();
    });
  };
  for (const Finding& finding : alternatives.front()) {
    if (in_all(finding)) diagnosis.certain.push_back(finding);
  }
  if (alternatives.size() == 1) return diagnosis;
  for (Alternative& each : alternatives) {
    std::erase_if(each, [&](const Finding& finding) {
      return std::find(diagnosis.certain.begin(), diagnosis.certain.end(), finding) !=
             diagnosis.certain.end();
    });
  }
  diagnosis.one_of = std::move(alternatives);
  return diagnosis;
}

const Stage* stage_named(std::string_view id) {
  const auto* const found = std::find_if(std::begin(stages), std::end(stages),
                                         [&](const Stage& stage) { return stage.id == id; });
  return found == std::end(stages) ? nullptr : found;
}

/// Whether the frames with both kinds of lights are the sum of those with one kind each, less the
/// ambient light that is in both.
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
      if (!cut_off && !(std::abs(sum - came) <= slack * (1 + std::abs(came)))) {
        // The background is in each of them.
        if (point != came || directional != came) return false;
      }
    }
  }
  return true;
}

/// Where a mistake that shows in the lights of one kind only is made. What the catalogue has for
/// one kind alone says so itself; P and N are the same for both, so there it is no explanation.
std::optional<Finding> only_in(const Finding& finding, Where where) {
  const Misconception& mistake = misconception(finding.mistake);
  if (mistake.slot == Slot::P || mistake.slot == Slot::N || mistake.slot == Slot::call) return {};
  const bool for_one_kind =
      (mistake.stages & in_point) == 0 || (mistake.stages & in_directional) == 0;
  return Finding{finding.mistake, for_one_kind ? Where::everywhere : where};
}

/// A mistake that both kinds of lights show is made everywhere. Nothing where it cannot be.
std::optional<Alternative> both(const Alternative& point, const Alternative& directional) {
  Alternative mistakes;
  const auto has = [](const Alternative& alternative, const Finding& finding) {
    return std::find(alternative.begin(), alternative.end(), finding) != alternative.end();
  };
  for (const Finding& finding : point) {
    const auto where = has(directional, finding) ? finding : only_in(finding, Where::point_lights);
    if (!where) return std::nullopt;
    mistakes.push_back(*where);
  }
  for (const Finding& finding : directional) {
    if (has(point, finding)) continue;
    const auto where = only_in(finding, Where::directional_lights);
    if (!where) return std::nullopt;
    mistakes.push_back(*where);
  }
  return mistakes;
}

/// The lights of each kind alone, as the stages of one kind have them: what is explained there is
/// explained in the sum, if it is one.
std::vector<Alternative> by_kind(std::span<const Frame> frames) {
  const std::size_t scenes = base_scenes().size();
  const Stage* point = stage_named("point");
  const Stage* directional = stage_named("directional");
  if (frames.size() < 4 * scenes || point == nullptr || directional == nullptr) return {};
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

std::string where(const Finding& finding) {
  const std::string name = say(misconception(finding.mistake).name);
  if (finding.where == Where::point_lights) return say(text::diagnosis_point, {name});
  if (finding.where == Where::directional_lights) return say(text::diagnosis_directional, {name});
  return name;
}

void add_words(std::vector<std::string>& lines, const std::vector<Finding>& findings,
               const std::string& indent) {
  for (const Finding& finding : findings) {
    const Misconception& mistake = misconception(finding.mistake);
    lines.push_back(indent + where(finding));
    lines.push_back(indent + "  " + say(mistake.question));
    lines.push_back(indent + "  " + say(text::diagnosis_look, {say(mistake.look)}));
  }
}

}  // namespace

const StageMistakes& mistakes_of(const Stage& stage) {
  static std::map<std::string_view, StageMistakes> kept;
  const auto found = kept.find(stage.id);
  if (found != kept.end()) return found->second;
  const std::filesystem::path folder = FOS_MISTAKES_DATA;
  return kept
      .emplace(stage.id,
               read_mistakes(folder / fmt::format("{}.mistakes", stage.id), base_scenes()))
      .first->second;
}

Diagnosis diagnose(const Stage& stage, std::span<const Frame> frames) {
  const Match whole = match(stage, frames);
  if (whole.right || whole.too_many) return {};
  if (whole.known()) return settle(whole.alternatives);
  if (frames.size() > base_scenes().size()) return settle(by_kind(frames));
  return {};
}

std::vector<std::string> describe(const Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  add_words(lines, diagnosis.certain, "");
  if (diagnosis.one_of.empty()) return lines;
  lines.push_back(
      say(diagnosis.certain.empty() ? text::diagnosis_one_of : text::diagnosis_and_one_of));
  for (std::size_t i = 0; i < diagnosis.one_of.size(); ++i) {
    if (i > 0) lines.push_back(say(text::diagnosis_or));
    add_words(lines, diagnosis.one_of[i], "  ");
  }
  return lines;
}

}  // namespace fos
