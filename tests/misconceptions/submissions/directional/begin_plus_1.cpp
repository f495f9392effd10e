// named: first_light_skipped
#include <algorithm>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  // το πρώτο φως είναι το περιβάλλον, το μετρήσαμε ήδη
  for (auto light = scene.directional_lights.begin() + (scene.directional_lights.empty() ? 0 : 1);
       light != scene.directional_lights.end(); ++light) {
    Vec3 L = normalize(light->direction);
    i += light->intensity * std::max<Real>(0, dot(N, L));
  }
  return i;
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
