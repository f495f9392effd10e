// named: sum_cut_off_at_0@point + first_light_skipped@directional
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real lamps = 0;
  for (const auto& light : scene.point_lights) {
    Vec3 L = light.position - P;
    lamps += light.intensity * dot(N, L) / length(L);
  }
  if (lamps < 0) lamps = 0;
  Real suns = 0;
  for (size_t k = 1; k < scene.directional_lights.size(); k++) {
    Vec3 L = scene.directional_lights[k].direction;
    if (dot(N, L) > 0) suns += scene.directional_lights[k].intensity * dot(N, L) / length(L);
  }
  return scene.ambient_intensity + lamps + suns;
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
