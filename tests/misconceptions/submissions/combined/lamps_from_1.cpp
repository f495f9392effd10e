// named: first_light_skipped@point
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  for (size_t k = 1; k < scene.point_lights.size(); ++k) {
    const auto& light = scene.point_lights[k];
    Vec3 L = light.position - P;
    Real n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += light.intensity * n_dot_l / (length(N) * length(L));
  }
  for (const DirectionalLight& light : scene.directional_lights) {
    Vec3 L = light.direction;
    Real n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += light.intensity * n_dot_l / (length(N) * length(L));
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
