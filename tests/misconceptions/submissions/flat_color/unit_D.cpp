// right
#include <utility>

#include "fos/stage.hpp"

namespace fos {

std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& s) {
  const Real len = length(D);
  const Vec3 u = D / len;
  const Real m = dot(s.center - O, u);                 // πλησιέστερο σημείο στο κέντρο
  const Vec3 away = s.center - O - m * u;
  const Real h2 = s.radius * s.radius - dot(away, away);
  if (h2 < 0) return {infinity, infinity};
  return {(m - sqrt(h2)) / len, (m + sqrt(h2)) / len};
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
