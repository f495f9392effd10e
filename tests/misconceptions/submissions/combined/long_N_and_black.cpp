// named: N_not_normalised + ambient_where_lit
#include <cmath>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = 0;
  for (auto& light : scene.point_lights) i += light.intensity * fmax(0, dot(N, normalize(light.position - P)));
  for (auto& light : scene.directional_lights) i += light.intensity * fmax(0, dot(N, normalize(light.direction)));
  if (i <= 0) return 0;
  return scene.ambient_intensity + i;
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  Vec3 P = O + hit->t * D;
  Vec3 N = P - hit->sphere->center;
  return hit->sphere->color * compute_lighting(P, N, scene);
}

}  // namespace fos
