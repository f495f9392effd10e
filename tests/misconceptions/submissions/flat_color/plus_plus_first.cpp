// named: first_sphere_skipped
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
  Color color = scene.background_color;
  Real best = t_max;
  auto it = scene.spheres.begin();
  while (++it < scene.spheres.end()) {
    auto [far, near] = intersect_ray_sphere(O, D, *it);
    Real t = near >= t_min ? near : far;
    if (t >= t_min && t < best) {
      best = t;
      color = it->color;
    }
  }
  return color;
}

}  // namespace fos
