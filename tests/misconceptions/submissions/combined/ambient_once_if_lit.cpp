// named: ambient_where_lit
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = 0;
  for (const PointLight& light : scene.point_lights) {
    Vec3 L = light.position - P;
    Real n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += light.intensity * n_dot_l / (length(N) * length(L));
  }
  for (const DirectionalLight& light : scene.directional_lights) {
    Vec3 L = light.direction;
    Real n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += light.intensity * n_dot_l / (length(N) * length(L));
  }
  return i > 0 ? i + scene.ambient_intensity : 0;
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
