// The closest intersection of a ray with the scene: what lecture 3 built, given to later lectures.
#pragma once

#include <cmath>
#include <optional>

#include "fos/scene.hpp"

namespace fos {

struct Hit {
  Real t;                ///< the hit is at O + t D
  const Sphere* sphere;  ///< in scene.spheres
};

/// The nearest hit with t in the closed interval [t_min, t_max], or nothing. O is any point and D
/// any direction but 0, of any length. Both intersections of a sphere count, so that from inside
/// one its far side is seen; a tangent ray hits; of two equal t the sphere that comes first wins.
///
/// It solves |O + t D − C|² = r² without the slides' b² − 4ac, which loses half the digits for a
/// sphere far away (Haines, Günther, Akenine-Möller, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems, 2019). While no square over- or underflows, with ε the type's:
///   | |O + t D − C| − r | <= 12 ε (|OC| + r)      for the t of a hit;
///   a sphere is hit or missed as in exact arithmetic, unless the ray's line passes the centre at a
///   distance l with | l − r | <= 12 ε (|OC| + r).
/// So rounding moves the surface by no more than a dozen units in the last place of the lengths
/// that are given, however far, near or flat it is; b² − 4ac moves it by √ε |OC|. Why, with
/// u = ε/2: V and h = V·D err by u|V| and 4u|V||D|, h/a by 8u|V| along the ray, so l, the vector
/// across, by 3u|V| plus at most those 8u|V|; r² − l² by 5u r² more, as if r erred by 2.5u r. Along
/// the ray the far root q/a then errs by at most 9u|V| + 8u r, and the near one c/q, of
/// which c errs by 6u|V|² + 2u r², by 13u|V| + 13u r, or moves across the surface by no more
/// than that. The sums are below 24u (|V| + r). (Terms in ε² apart; a test measures 2 ε.)
inline std::optional<Hit> closest_hit(const Vec3& O, const Vec3& D, Real t_min, Real t_max,
                                      const Scene& scene) {
  const Real a = dot(D, D);
  Real closest_t = infinity;
  const Sphere* closest = nullptr;
  const auto consider = [&](Real t, const Sphere& sphere) {
    if (t < closest_t && t_min <= t && t <= t_max) {
      closest_t = t;
      closest = &sphere;
    }
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
    consider(q == 0 ? 0 : c / q, sphere);
    consider(q / a, sphere);
  }
  if (closest == nullptr) return std::nullopt;
  return Hit{closest_t, closest};
}

}  // namespace fos
