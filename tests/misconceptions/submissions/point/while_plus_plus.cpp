// named: first_light_skipped
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  std::size_t n = 0;
  while (++n < scene.point_lights.size()) {
    const Vec3 L = scene.point_lights[n].position - P;
    const Real cosine = dot(N, L) / length(L);
    if (cosine > 0) i += scene.point_lights[n].intensity * cosine;
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
