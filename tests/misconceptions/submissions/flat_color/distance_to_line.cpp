// right
#include <utility>

#include "fos/stage.hpp"

namespace fos {

// πόσο απέχει το κέντρο από την ευθεία της ακτίνας
std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& s) {
  const Vec3 OC = s.center - O;
  const Real middle = dot(OC, D) / dot(D, D);
  const Real distance = length(OC - middle * D);
  if (distance > s.radius) return {infinity, infinity};
  const Real half = sqrt((s.radius - distance) * (s.radius + distance)) / length(D);
  return {middle - half, middle + half};
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
