// The slides' formulas, for what is promised of every valid scene.
#pragma once

#include <cmath>

#include "fos/scene_file.hpp"

namespace fos {

/// Whether all that the slides' formulas, word for word, give at every pixel is finite: for both
/// roots of every sphere that the ray meets, in front of the camera or not.
inline bool slides_stay_finite(const SceneFile& file) {
  for (int row = 0; row < file.view.canvas_height; ++row) {
    for (int column = 0; column < file.view.canvas_width; ++column) {
      const Vec3 O = file.view.camera_position;
      const Vec3 D = canvas_to_viewport(file.view, column, row);
      for (const Sphere& each : file.scene.spheres) {
        const Vec3 CO = O - each.center;
        const Real a = dot(D, D);
        const Real b = 2 * dot(CO, D);
        const Real c = dot(CO, CO) - each.radius * each.radius;
        const Real disc = b * b - 4 * a * c;
        if (!std::isfinite(disc)) return false;
        if (disc < 0) continue;
        for (const Real sign : {Real(-1), Real(1)}) {
          const Real t = (-b + sign * std::sqrt(disc)) / (2 * a);
          if (!std::isfinite(t)) return false;
          const Vec3 P = O + t * D;
          Vec3 N = P - each.center;
          N = N / length(N);
          // Of a NaN the slides' `if n_dot_l > 0` makes darkness, which is finite.
          if (!std::isfinite(length(N))) return false;
          Real I = file.scene.ambient_intensity;
          const auto add = [&](Real intensity, const Vec3& L) {
            if (dot(N, L) > 0) I += intensity * dot(N, L) / (length(N) * length(L));
          };
          for (const auto& light : file.scene.point_lights)
            add(light.intensity, light.position - P);
          for (const auto& light : file.scene.directional_lights)
            add(light.intensity, light.direction);
          if (!std::isfinite(255 * I)) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace fos
