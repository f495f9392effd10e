// named: N_inward
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real lambert(Vec3 n, Vec3 l) {
  Real d = -dot(n, l);
  return d > 0 ? d / (length(n) * length(l)) : 0;
}

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real total = scene.ambient_intensity;
  for (auto& l : scene.directional_lights) total += l.intensity * lambert(N, l.direction);
  for (auto& l : scene.point_lights) total += l.intensity * lambert(N, l.position - P);
  return total;
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  Vec3 P = O + hit->t * D;
  Vec3 N = P - hit->sphere->center;
  N = N / length(N);
  return hit->sphere->color * compute_lighting(P, N, scene);
}

}  // namespace fos
