#include "mistakes.hpp"

#include <algorithm>
#include <iterator>

namespace fos {
namespace {

// The letters of mistakes.inc.
constexpr unsigned F = in_flat_color;
constexpr unsigned A = in_ambient;
constexpr unsigned P = in_point;
constexpr unsigned D = in_directional;
constexpr unsigned C = in_combined;

constexpr Misconception all[] = {
#define MISTAKE(id, slot, stages, look)                                                          \
  {Mistake::id,      #id, Slot::slot, stages, text::mistake_##id, text::mistake_##id##_question, \
   text::look_##look},
#include "mistakes.inc"
#undef MISTAKE
};
static_assert(std::size(all) <= 128, "MistakeSet has 128 bits");

}  // namespace

unsigned stage_bit(std::string_view stage_id) {
  constexpr std::string_view ids[] = {"flat_color", "ambient", "point", "directional", "combined"};
  const auto* const found = std::find(std::begin(ids), std::end(ids), stage_id);
  return found == std::end(ids) ? 0 : 1U << (found - std::begin(ids));
}

std::span<const Misconception> misconceptions() { return all; }

const Misconception& misconception(Mistake mistake) {
  return all[static_cast<std::size_t>(mistake)];
}

std::optional<Mistake> find_mistake(std::string_view id) {
  for (const Misconception& each : all) {
    if (each.id == id) return each.mistake;
  }
  return std::nullopt;
}

std::optional<Mistake> ending_of(const MistakeSet& mistakes) {
  for (const Misconception& each : all) {
    if (each.slot == Slot::ending && mistakes.has(each.mistake)) return each.mistake;
  }
  return std::nullopt;
}

MistakeSet::MistakeSet(std::initializer_list<Mistake> mistakes) {
  for (const Mistake mistake : mistakes) add(mistake);
}

std::vector<Mistake> MistakeSet::list() const {
  std::vector<Mistake> mistakes;
  for (const Misconception& each : all) {
    if (has(each.mistake)) mistakes.push_back(each.mistake);
  }
  return mistakes;
}

}  // namespace fos
