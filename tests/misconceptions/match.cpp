#include "match.hpp"

#include "explanation.hpp"

namespace fos {
namespace {

std::vector<Mistake> finishing(const Stage& stage) {
  std::vector<Mistake> mistakes;
  for (const Misconception& each : misconceptions()) {
    if (is_finish(each) && (each.stages & stage_bit(stage.id)) != 0)
      mistakes.push_back(each.mistake);
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

}  // namespace

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
  const auto named_alone = [](const Plane& plane) {
    return (plane.first && is_named_alone(*plane.first)) ||
           (plane.second && is_named_alone(*plane.second));
  };
  for (std::size_t count = 0; count <= 2 && !match.known(); ++count) {
    for (const Plane& plane : data.planes) {
      if (made(plane) > count || (named_alone(plane) && count > 1)) continue;
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

}  // namespace fos
