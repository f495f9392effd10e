// named: sine_for_cosine
#include <cmath>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  auto shade = [&](Vec3 L) -> Real {
    Real c = dot(N, L) / (length(N) * length(L));
    if (c <= 0) return 0;
    return std::sqrt(1 - c * c);
  };
  Real i = scene.ambient_intensity;
  for (auto& light : scene.point_lights) i += light.intensity * shade(light.position - P);
  for (auto& light : scene.directional_lights) i += light.intensity * shade(light.direction);
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
