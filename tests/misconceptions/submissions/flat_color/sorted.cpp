// right
#include <algorithm>
#include <utility>
#include <vector>

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
  std::vector<std::pair<Real, std::size_t>> hits;
  for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
    const auto [t1, t2] = intersect_ray_sphere(O, D, scene.spheres[k]);
    if (t1 >= t_min && t1 <= t_max && t1 != infinity) hits.emplace_back(t1, k);
    if (t2 >= t_min && t2 <= t_max && t2 != infinity) hits.emplace_back(t2, k);
  }
  if (hits.empty()) return scene.background_color;
  std::sort(hits.begin(), hits.end());  // ίδιο t: πρώτη η σφαίρα με τον μικρότερο δείκτη
  return scene.spheres[hits.front().second].color;
}

}  // namespace fos
