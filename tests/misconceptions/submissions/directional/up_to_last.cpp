// named: last_light_skipped
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  for (std::size_t k = 0; k + 1 < scene.directional_lights.size(); ++k) {
    const auto& [intensity, direction] = scene.directional_lights[k];
    const Real c = dot(N, direction) / length(direction);
    if (c > 0) i += intensity * c;
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
