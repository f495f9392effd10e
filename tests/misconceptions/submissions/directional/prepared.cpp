// right
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  auto I = scene.ambient_intensity;
  std::vector<Vec3> unit;
  for (auto& d : scene.directional_lights) unit.push_back(normalize(d.direction));
  for (std::size_t k = 0; k < unit.size(); ++k)
    I += scene.directional_lights[k].intensity * std::fmax(0, dot(unit[k], N));
  return I;
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
