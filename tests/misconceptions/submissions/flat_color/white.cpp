// named: white_background
#include <utility>

#include "fos/stage.hpp"

namespace fos {

std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& sphere) {
  Vec3 CO = O - sphere.center;
  Real a = dot(D, D);
  Real b = 2 * dot(CO, D);
  Real c = dot(CO, CO) - sphere.radius * sphere.radius;
  Real disc = b * b - 4 * a * c;
  if (disc < 0) return {infinity, infinity};
  return {(-b + sqrt(disc)) / (2 * a), (-b - sqrt(disc)) / (2 * a)};
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  Color color(255, 255, 255);  // λευκό φόντο
  Real nearest = infinity;
  for (const auto& s : scene.spheres) {
    auto [a, b] = intersect_ray_sphere(O, D, s);
    for (Real t : {a, b}) {
      if (t_min <= t && t <= t_max && t < nearest) { nearest = t; color = s.color; }
    }
  }
  return color;
}

}  // namespace fos
