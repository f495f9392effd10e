// named: no_sphere
#include <utility>

#include "fos/stage.hpp"

namespace fos {

std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& sphere) {
  Vec3 CO = O - sphere.center;
  Real a = dot(D, D);
  Real b = 2 * dot(CO, D);
  Real c = dot(CO, CO);
  Real disc = b * b - 4 * a * c;
  if (disc < 0) return {infinity, infinity};
  return {(-b + sqrt(disc)) / (2 * a), (-b - sqrt(disc)) / (2 * a)};
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  Real closest_t = infinity;
  const Sphere* closest = nullptr;
  for (const Sphere& s : scene.spheres) {
    auto [t1, t2] = intersect_ray_sphere(O, D, s);
    if (t1 >= t_min && t1 <= t_max && t1 < closest_t) {
      closest_t = t1;
      closest = &s;
    }
    if (t2 >= t_min && t2 <= t_max && t2 < closest_t) {
      closest_t = t2;
      closest = &s;
    }
  }
  if (closest == nullptr) return scene.background_color;
  return closest->color;
}

}  // namespace fos
