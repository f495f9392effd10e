// named: cut_off_at_1
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  for (const PointLight& light : scene.point_lights) {
    Vec3 L = light.position - P;
    Real n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += light.intensity * n_dot_l / (length(N) * length(L));
  }
  // η ένταση είναι από 0 έως 1
  if (i > 1) i = 1;
  return i;
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  const Sphere& s = *hit->sphere;
  auto P = O + D * hit->t;
  auto N = normalize(P - s.center);   // κανονικό διάνυσμα
  Real I = compute_lighting(P, N, scene);
  return I * s.color;
}

}  // namespace fos
