// The catalogue of the mistakes that students make over the stages: names, words, and what goes
// with what.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fos/stage_list.hpp"
#include "fos/text.hpp"

namespace fos {

/// One wrong line of a stage.
enum class Mistake : std::uint8_t {
#define MISTAKE(id, slot, stages, look) id,
#include "mistakes.inc"
#undef MISTAKE
};

/// Which line a mistake changes. Two mistakes of one slot exclude each other.
enum class Slot : std::uint8_t {
  ray,
  spheres,
  CO,
  a,
  b,
  c,
  discriminant,
  tangent,
  root,
  divisor,
  roots,
  interval,
  closest,
  background,
  P,
  N,
  N_length,
  call,
  L,
  sign,
  L_length,
  cosine,
  intensity,
  lights,
  sum,
  kinds,
  ambient,
  type,
  total,
  ending,
};

struct Misconception {
  Mistake mistake;
  std::string_view id;  ///< also the name of its picture
  Slot slot;
  unsigned stages;       ///< StageBit of each stage that it can be made in
  const Text& name;      ///< what is wrong, in a few words
  const Text& question;  ///< leads to it without giving the answer
  const Text& look;      ///< the slide, by its Greek title, and the formula
};

/// The stages as bits, in the course's order.
enum StageBit : unsigned {
  in_flat_color = 1,
  in_ambient = 2,
  in_point = 4,
  in_directional = 8,
  in_combined = 16
};

/// The bit of a stage; 0 for one that the catalogue does not know.
unsigned stage_bit(std::string_view stage_id);

/// Every mistake, at the index that is its number.
std::span<const Misconception> misconceptions();

const Misconception& misconception(Mistake mistake);

/// By its id; nothing where there is none of that name.
std::optional<Mistake> find_mistake(std::string_view id);

/// A few mistakes made together.
class MistakeSet {
 public:
  MistakeSet() = default;
  MistakeSet(std::initializer_list<Mistake> mistakes);

  bool has(Mistake mistake) const { return made_[static_cast<std::size_t>(mistake)]; }
  void add(Mistake mistake) { made_.set(static_cast<std::size_t>(mistake)); }
  std::vector<Mistake> list() const;
  bool operator==(const MistakeSet&) const = default;

 private:
  std::bitset<128> made_;
};

/// The mistake of a set in the ending of trace_ray, or nothing.
std::optional<Mistake> ending_of(const MistakeSet& mistakes);

/// Whether a mistake is never named together with another: the same picture comes of too many other
/// causes for that.
constexpr bool is_named_alone(Mistake mistake) { return mistake == Mistake::no_sphere; }

/// Whether what a mistake makes of a pixel follows from the sphere that is seen and I alone, so
/// that the data need not hold it.
constexpr bool is_finish(const Misconception& mistake) {
  return mistake.slot == Slot::background || mistake.slot == Slot::total ||
         mistake.slot == Slot::ending;
}

}  // namespace fos
