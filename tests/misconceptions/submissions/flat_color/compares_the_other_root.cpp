// named: nothing
#include <utility>

#include "fos/stage.hpp"

namespace fos {

// The slides' IntersectRaySphere: the two t where the ray O + t D meets the sphere, or twice
// infinity where it misses.
std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& sphere) {
  const Vec3 CO = O - sphere.center;
  const Real r = sphere.radius;

  const Real a = dot(D, D);
  const Real b = 2 * dot(CO, D);
  const Real c = dot(CO, CO) - r * r;

  const Real discriminant = b * b - 4 * a * c;
  if (discriminant < 0) {
    return {infinity, infinity};
  }
  const Real t1 = (-b + std::sqrt(discriminant)) / (2 * a);
  const Real t2 = (-b - std::sqrt(discriminant)) / (2 * a);
  return {t1, t2};
}

// The slides' TraceRay: the color of the nearest sphere that the ray meets for t in [t_min, t_max],
// or the background.
Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  Real closest_t = infinity;
  const Sphere* closest_sphere = nullptr;
  for (const Sphere& sphere : scene.spheres) {
    const auto [t1, t2] = intersect_ray_sphere(O, D, sphere);
    if (t_min <= t1 && t1 <= t_max && t2 < closest_t) {
      closest_t = t1;
      closest_sphere = &sphere;
    }
    if (t_min <= t2 && t2 <= t_max && t2 < closest_t) {
      closest_t = t2;
      closest_sphere = &sphere;
    }
  }
  if (closest_sphere == nullptr) {
    return scene.background_color;
  }
  return closest_sphere->color;
}

}  // namespace fos
