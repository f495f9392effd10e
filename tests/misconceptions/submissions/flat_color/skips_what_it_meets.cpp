// named: discriminant_reversed
#include <cmath>

#include "fos/stage.hpp"

namespace fos {

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  Real closest_t = infinity;
  Color color = scene.background_color;
  for (const Sphere& s : scene.spheres) {
    Vec3 CO = O - s.center;
    Real a = dot(D, D), b = 2 * dot(CO, D), c = dot(CO, CO) - s.radius * s.radius;
    Real disc = b * b - 4 * a * c;
    if (disc > 0) continue;  // δεν υπάρχουν λύσεις
    for (int sign : {-1, 1}) {
      Real t = (-b + sign * std::sqrt(disc)) / (2 * a);
      if (t < closest_t && t_min <= t && t <= t_max) {
        closest_t = t;
        color = s.color;
      }
    }
  }
  return color;
}

}  // namespace fos
