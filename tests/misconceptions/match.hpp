// What explains the frames of a stage on the base scenes with the fewest mistakes.
#pragma once

#include <span>
#include <vector>

#include "diagnosis.hpp"

namespace fos {

/// More alternatives than this say nothing.
inline constexpr std::size_t most_alternatives = 3;

/// Mistakes that are made together.
using Alternative = std::vector<MistakeMade>;

struct Match {
  bool right = false;
  bool too_many = false;  ///< so many that they say nothing
  std::vector<Alternative> alternatives;
  bool known() const { return right || !alternatives.empty(); }
};

/// The frames of the base scenes come first.
Match match(const Stage& stage, std::span<const Frame> frames);

/// For a stage with lights of both kinds: what explains the frames with one kind alone, as the
/// stages of one kind have them, if those with both are their sum. Empty where nothing does.
std::vector<Alternative> match_by_kind(std::span<const Frame> frames);

}  // namespace fos
