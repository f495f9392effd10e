// named: sum_cut_off_at_0
#include <algorithm>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real sum = 0;
  for (auto& light : scene.point_lights) {
    Vec3 L = normalize(light.position - P);
    sum += light.intensity * dot(normalize(N), L);
  }
  return scene.ambient_intensity + std::max<Real>(0, sum);
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (hit) {
    const Sphere& sphere = *hit->sphere;
    const Vec3 point = O + D * hit->t;
    const Vec3 normal = normalize(point - sphere.center);
    return compute_lighting(point, normal, scene) * sphere.color;
  }
  return scene.background_color;
}

}  // namespace fos
