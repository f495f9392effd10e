// named: first_sphere_is_background
#include <utility>

#include "fos/stage.hpp"

namespace fos {

std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& sphere) {
  Vec3 CO = O - sphere.center;
  Real a = dot(D, D);
  Real b = 2 * dot(CO, D);
  Real c = dot(CO, CO) - sphere.radius * sphere.radius;
  Real disc = b * b - 4 * a * c;
  if (disc < 0) return {infinity, infinity};
  return {(-b + sqrt(disc)) / (2 * a), (-b - sqrt(disc)) / (2 * a)};
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  unsigned closest = 0;
  Real nearest = t_max;
  for (unsigned k = 0; k < scene.spheres.size(); k++) {
    const auto roots = intersect_ray_sphere(O, D, scene.spheres[k]);
    const Real t = roots.second >= t_min ? roots.second : roots.first;
    if (t >= t_min && t < nearest) {
      nearest = t;
      closest = k;
    }
  }
  if (closest < 0) return scene.background_color;
  return scene.spheres[closest].color;
}

}  // namespace fos
