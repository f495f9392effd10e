// A canvas on which the whole study fits into its time.
#pragma once

#include <functional>

#include "rung.hpp"

namespace fos::numerics {

/// The scene on a canvas that is smaller by a whole factor, rounded up. Where the factor divides
/// both sides, its rays are among those of the whole canvas.
SceneText made_smaller(const SceneText& scene, int factor);

/// What one pixel takes, in seconds.
struct Cost {
  double truth = 0;
  double round = 0;  ///< all rungs once
};

struct Fit {
  int factor = 1;
  double truth_seconds = 0;  ///< about, on that canvas
  double round_seconds = 0;
};

/// The smallest factor with which `cost` stays within the study's time.
Fit fit(const SceneText& scene, const Cost& cost);

/// Measures the costs on small canvases. `rungs_of` makes the rungs for a canvas.
Cost cost_of(const SceneText& scene,
             const std::function<std::vector<Rung>(const SceneText&)>& rungs_of);

/// How long all rounds together may take.
inline constexpr double seconds_for_rounds = 18;
inline constexpr int rounds_aimed_at = 15;

}  // namespace fos::numerics
