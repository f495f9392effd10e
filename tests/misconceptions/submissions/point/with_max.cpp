// right
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real sum = 0;
  for (size_t k = 0; k < scene.point_lights.size(); k++) {
    const auto& l = scene.point_lights[k];
    Vec3 d = l.position - P;
    if (length(d) == 0) continue;
    sum = sum + l.intensity * std::max<Real>(0, dot(normalize(N), normalize(d)));
  }
  return sum + scene.ambient_intensity;
}

Vec3 normal_at(const Vec3& p, const Sphere& sphere) { return (p - sphere.center) / sphere.radius; }

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  Vec3 point = O + D * hit->t;
  Vec3 n = normal_at(point, *hit->sphere);
  Real light = compute_lighting(point, n, scene);
  Color c = hit->sphere->color;
  c.x = c.x * light;
  c.y = c.y * light;
  c.z = c.z * light;
  return c;
}

}  // namespace fos
