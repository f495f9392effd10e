// What a scene requires to be computed, decided once, before the first pixel.
//
// A plan never changes a byte: what it leaves out is proven not to matter, or is within the error
// that the floats' bound carries anyway, so that a pixel which hangs on it is done again in full.
#pragma once

#include <vector>

#include "camera_scene.hpp"

namespace fos::certified {

struct Plan {
  /// Which spheres may be seen at all, as positions in CameraScene::spheres. The others lie before
  /// the plane t = 1, outside the canvas, or are equal to an earlier one.
  std::vector<int> spheres;
  /// Each sphere only in the rows and columns where it may be seen.
  bool within_outlines = true;
  /// Some light beside the ambient one shines: P and N are needed.
  bool shade = true;
  /// By light: how far its directional replacement is off at most, as a share of its intensity;
  /// -1 where it is not replaced.
  std::vector<double> replaced;
  /// Floats first; else doubles from the start.
  bool in_float = true;
};

/// A replaced light may be off by so much of its intensity: about what floats lose anyway (eight
/// roundings), so that few pixels more are left undecided.
inline constexpr double replacement_budget = 0x1p-21;

/// The bound |ΔI| / I of a point light at distance `distance` from the camera that a directional
/// one replaces, for surfaces within `reach` of the camera: 2 sin(½ asin(reach / distance)).
double replacement_bound(double reach, double distance);

/// No point on a sphere that floats shade is farther from the camera.
double reach(const CameraSphere& sphere);

/// That of all spheres that may be seen.
double reach(const CameraScene& scene);

/// What the scene requires, and nothing else.
Plan plan(const CameraScene& scene);

/// Everything for every scene: the plan without a decision.
Plan general_plan(const CameraScene& scene);

}  // namespace fos::certified
