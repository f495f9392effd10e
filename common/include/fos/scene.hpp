// What a stage is given: spheres and lights, in the numbers it computes with.
#pragma once

#include <vector>

#include "fos/math.hpp"

namespace fos {

struct Sphere {
  Vec3 center{0};
  Real radius = 1;  ///< > 0
  Color color{0};   ///< each channel 0..255
};

/// Shines from one point, equally in all directions, and does not fade with distance.
struct PointLight {
  Real intensity = 0;  ///< >= 0
  Vec3 position{0};
};

/// Shines from one direction everywhere, like the sun.
struct DirectionalLight {
  Real intensity = 0;  ///< >= 0
  Vec3 direction{0};   ///< from the surface TOWARD the light: L itself; any length but 0
};

/// The slides' `scene`. Its lights stand apart by kind: I_A, then the terms of the two sums.
///
/// For a scene that came from a file, the slides' formulas give neither NaN nor infinity at any
/// pixel: scene_file.hpp refuses a scene that Real cannot carry through them.
struct Scene {
  Color background_color{255};
  std::vector<Sphere> spheres;
  Real ambient_intensity = 0;  ///< I_A >= 0
  std::vector<PointLight> point_lights;
  std::vector<DirectionalLight> directional_lights;
};

}  // namespace fos
