// The stages, as labs/stages.json lists them.
#pragma once

#include <span>
#include <string_view>

#include "fos/text.hpp"

namespace fos {

/// The terms that a stage's I is the sum of, as bits. A stage without any shows the plain color, I
/// = 1.
enum Term : unsigned { ambient_term = 1, point_term = 2, directional_term = 4 };

struct Stage {
  std::string_view id;  ///< flat_color, ambient, …: the file, the targets and the pictures
  int lecture;
  Text name;
  unsigned terms;                            ///< Term bits
  int points;                                ///< what the stage is worth
  std::span<const std::string_view> scenes;  ///< what it is checked with, by reference file
};

}  // namespace fos

#include "fos/stages.inc"  // generated: `inline constexpr Stage stages[]`, in the course's order
