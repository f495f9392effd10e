// named: L_from_center
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene);

Real light_up(const Vec3& C, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  for (auto l : scene.point_lights) {
    auto L = normalize(l.position - C);
    i += l.intensity * std::max(dot(N, L), Real(0));
  }
  return i;
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  Vec3 P = O + hit->t * D;
  Vec3 N = normalize(P - hit->sphere->center);
  return hit->sphere->color * light_up(hit->sphere->center, N, scene);
}

}  // namespace fos
