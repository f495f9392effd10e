// What is right at one pixel, step by step in the slides' letters: every number exact, or
// enclosed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "certified_light.hpp"
#include "fos/scene_text.hpp"

namespace fos {

/// Where the ray's line meets a sphere: a t² + b t + c = 0.
struct SphereMet {
  mpq_class discriminant;  ///< b² - 4ac; where it is < 0 there are no roots
  /// t1 = (-b + √disc) / (2a), t2 = (-b - √disc) / (2a).
  std::array<reference::Enclosure, 2> roots;
  std::array<bool, 2> counts{};  ///< t in [1, inf)
};

/// Why a light adds something, or nothing.
enum class Shine {
  lit,      ///< <N, L> > 0
  grazing,  ///< <N, L> = 0
  behind,   ///< <N, L> < 0
  at_P,     ///< L = 0
};

/// A point or directional light at the hit.
struct LightMet {
  std::size_t index = 0;  ///< in SceneText::lights
  Shine shine = Shine::lit;
  reference::Triple<reference::Enclosure> L;
  reference::Enclosure N_dot_L;
  reference::Enclosure L_length;
  reference::Enclosure cosine;   ///< <N, L> / (|N| |L|), negative ones too; 0 at P
  reference::Enclosure degrees;  ///< the angle of N and L
  reference::Enclosure term;     ///< I_i times the cosine, or 0
};

/// The point that the ray sees.
struct Hit {
  int sphere = 0;  ///< its number in the file, from 1
  int root = 0;    ///< 0: t1, 1: t2
  reference::Enclosure t;
  reference::Triple<reference::Enclosure> P;
  reference::Triple<reference::Enclosure> N;  ///< CP / |CP|
  std::vector<LightMet> lights;               ///< in the order of the file, all of the scene
};

struct Chain {
  mpq_class x;  ///< pixels to the right of the canvas' middle
  mpq_class y;  ///< upward
  reference::Triple<mpq_class> D;
  std::vector<SphereMet> spheres;  ///< in the order of the file
  std::optional<Hit> hit;          ///< nothing: the background
  reference::Enclosure I{1, 1};    ///< the sum of the stage's terms; 1 for the background
  reference::Triple<reference::Enclosure> channels;  ///< color x I, or the background
  std::array<std::uint8_t, 3> bytes{};
};

/// The chain of a stage whose I sums up `terms` (Stage::terms). The pixel lies on the canvas.
/// Throws std::range_error for numbers beyond 10^±10000, reference::UndecidedError.
Chain certified_chain(const SceneText& scene, unsigned terms, int column, int row);

/// The oracle's word for `terms`.
unsigned oracle_terms(unsigned terms);

}  // namespace fos
