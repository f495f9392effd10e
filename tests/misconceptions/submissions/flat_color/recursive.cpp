// right
#include <cstddef>
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

// η κοντινότερη από τις σφαίρες k, k + 1, …
std::pair<Real, const Sphere*> nearest(std::size_t k, const Vec3& O, const Vec3& D, Real t_min,
                                       Real t_max, const Scene& scene) {
  if (k == scene.spheres.size()) return {infinity, nullptr};
  const auto rest = nearest(k + 1, O, D, t_min, t_max, scene);
  const auto [far, near] = intersect_ray_sphere(O, D, scene.spheres[k]);
  const Real t = near >= t_min ? near : far;
  if (t >= t_min && t <= t_max && t != infinity && t <= rest.first) return {t, &scene.spheres[k]};
  return rest;
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto [t, sphere] = nearest(0, O, D, t_min, t_max, scene);
  return sphere != nullptr ? sphere->color : scene.background_color;
}

}  // namespace fos
