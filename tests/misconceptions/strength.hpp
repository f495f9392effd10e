// What the strength of a light depends on that it should not: the ratio of a stage's term to the
// right one, over many pixels.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fos {

/// What a number is known to lie between: the data hold cells of values.
struct Range {
  double low = 0;
  double high = 0;
  double middle() const { return (low + high) / 2; }
};

/// A pixel that a light reaches, and how much of it comes back there.
struct Lit {
  Range ratio;             ///< the stage's term / the right one
  std::size_t light = 0;   ///< which light
  std::size_t sphere = 0;  ///< which sphere of which scene
  Range distance;          ///< |L|, 0 where the light is directional
  double cosine = 0;       ///< of the angle between N and L
};

enum class Dependence { none, constant, light, sphere, distance, angle, unknown };

struct Strength {
  Dependence on = Dependence::none;
  double factor = 1;         ///< of a constant
  std::optional<int> power;  ///< of the distance, where the ratio is a power of it
};

/// Of a few pixels (fewer than 20) nothing is said: unknown.
Strength strength_of(const std::vector<Lit>& pixels);

/// In words, in the language of this process.
std::string describe(const Strength& strength);

}  // namespace fos
