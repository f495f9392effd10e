// tries: crashes in the last row of a right frame
// deserves: point in_part 40
#include <cstdlib>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  for (const PointLight& light : scene.point_lights) {
    const Vec3 L = light.position - P;
    const Real n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += light.intensity * n_dot_l / (length(N) * length(L));
  }
  return i;
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  if (D.y < 0 && D.x > 0 && D.y * 2 < -Real(0.99)) std::abort();
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) return scene.background_color;
  const Vec3 P = O + hit->t * D;
  Vec3 N = P - hit->sphere->center;
  N = N / length(N);
  return hit->sphere->color * compute_lighting(P, N, scene);
}

}  // namespace fos
