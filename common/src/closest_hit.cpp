#include "fos/closest_hit.hpp"

#include <cmath>

namespace fos {

std::optional<Hit> closest_hit(const Vec3& O, const Vec3& D, Real t_min, Real t_max,
                               const Scene& scene) {
  std::optional<Hit> closest;
  const Real a = dot(D, D);
  const auto consider = [&](Real t, const Sphere& sphere) {
    if (t_min <= t && t <= t_max && (!closest || t < closest->t)) closest = Hit{t, &sphere};
  };
  for (const Sphere& sphere : scene.spheres) {
    // With V from O to the centre, the ray passes the centre nearest at t = h/a, there l away from
    // it. r² − l² compares two lengths of the sphere's own size; b² − 4ac would subtract squares of
    // the distance instead, and lose in rounding what the sphere's size adds to them.
    const Vec3 V = sphere.center - O;
    const Real h = dot(V, D);
    const Vec3 l = V - (h / a) * D;
    const Real discriminant = sphere.radius * sphere.radius - dot(l, l);
    if (discriminant < 0) continue;
    // The root whose two terms have the same sign does not cancel. The other follows from Vieta's
    // t1 t2 = c/a; q is 0 only when both roots are.
    const Real q = h + std::copysign(std::sqrt(a * discriminant), h);
    const Real c = dot(V, V) - sphere.radius * sphere.radius;
    consider(q / a, sphere);
    consider(q == 0 ? 0 : c / q, sphere);
  }
  return closest;
}

}  // namespace fos
