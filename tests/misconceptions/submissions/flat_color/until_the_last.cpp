// named: last_sphere_skipped
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
  if (scene.spheres.empty()) return scene.background_color;
  Real best = infinity;
  const Sphere* found = nullptr;
  // από την πρώτη σφαίρα ως την τελευταία
  for (const Sphere* s = &scene.spheres.front(); s != &scene.spheres.back(); ++s) {
    const auto roots = intersect_ray_sphere(O, D, *s);
    for (Real t : {roots.first, roots.second}) {
      if (t < t_min || t > t_max || t >= best) continue;
      best = t;
      found = s;
    }
  }
  return found ? found->color : scene.background_color;
}

}  // namespace fos
