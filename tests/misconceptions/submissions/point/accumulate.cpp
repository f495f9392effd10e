// right
#include <cmath>
#include <numeric>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  return std::accumulate(scene.point_lights.begin(), scene.point_lights.end(), scene.ambient_intensity,
                         [&](Real sum, const PointLight& light) {
                           const Vec3 L = light.position - P;
                           const Real cosine = dot(N, L) / sqrt(dot(N, N) * dot(L, L));
                           return cosine > 0 ? sum + light.intensity * cosine : sum;
                         });
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
