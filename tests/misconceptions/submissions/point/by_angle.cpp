// right
#include <algorithm>
#include <cmath>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  for (const PointLight& light : scene.point_lights) {
    Vec3 L = light.position - P;
    const Real angle = std::acos(std::clamp<Real>(dot(N, L) / (length(N) * length(L)), -1, 1));
    const Real quarter = std::acos(Real(0));
    if (angle < quarter) i += light.intensity * std::cos(angle);
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
