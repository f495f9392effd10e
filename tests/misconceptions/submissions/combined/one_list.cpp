// right
#include <cmath>
#include <vector>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  struct Lamp {
    Real intensity;
    Vec3 L;
  };
  std::vector<Lamp> lamps;
  for (const auto& light : scene.directional_lights) lamps.push_back({light.intensity, light.direction});
  for (const auto& light : scene.point_lights) lamps.push_back({light.intensity, light.position - P});
  Real total = scene.ambient_intensity;
  while (!lamps.empty()) {
    const auto [intensity, L] = lamps.back();
    lamps.pop_back();
    if (L == Vec3(0)) continue;
    const Real x = intensity * dot(N, L) / (length(N) * length(L));
    total += (x + std::abs(x)) / 2;  // x όταν είναι θετικό, αλλιώς 0
  }
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
