// named: sum_cut_off_at_0
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real diffuse = 0;
  for (const DirectionalLight& light : scene.directional_lights) {
    Vec3 L = light.direction;
    diffuse += light.intensity * dot(N, L) / (length(N) * length(L));
  }
  if (diffuse < 0) diffuse = 0;  // αρνητικό φως δεν υπάρχει
  return scene.ambient_intensity + diffuse;
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
