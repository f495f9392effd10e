// named: absolute_cosine
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = scene.ambient_intensity;
  for (const PointLight& light : scene.point_lights) {
    Vec3 L = light.position - P;
    i += light.intensity * std::fabs(dot(N, L)) / length(L);
  }
  return i;
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
