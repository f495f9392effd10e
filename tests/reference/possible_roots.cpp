#include "possible_roots.hpp"

namespace fos::reference {
namespace {

using Roots = std::optional<PossibleRoots>;

Interval whole(const Interval& like, int number) { return {like.bits(), number}; }

/// Of a t^2 + b t + c = 0, by the slides' formula.
Roots quadratic_roots(const Interval& a, const Interval& b, const Interval& c) {
  const Interval discriminant = square(b) - whole(a, 4) * a * c;
  if (discriminant.high_sign() < 0) return std::nullopt;
  const Interval root = sqrt(without_negative(discriminant));
  const Interval two_a = whole(a, 2) * a;
  return PossibleRoots{discriminant.low_sign() >= 0, (-b - root) / two_a, (-b + root) / two_a};
}

/// The ray is nearest to the center at t = -h / a; there the center is -f away.
Roots distance_roots(const RoundedSphere& sphere, const RoundedRay& ray) {
  const Interval nearest_t = -dot(sphere.CO, ray.D) / ray.a;
  const Triple<Interval> f = sphere.CO + nearest_t * ray.D;
  const Interval rest = sphere.r_squared - squared_length(f);
  if (rest.high_sign() < 0) return std::nullopt;
  const Interval half_chord = sqrt(without_negative(rest) / ray.a);
  return PossibleRoots{rest.low_sign() >= 0, nearest_t - half_chord, nearest_t + half_chord};
}

Roots divided(const Roots& roots, const Interval& length) {
  if (!roots) return std::nullopt;
  return PossibleRoots{roots->sure, roots->near / length, roots->far / length};
}

/// What either way may find.
Roots either(const Roots& x, const Roots& y) {
  if (x && y)
    return PossibleRoots{x->sure && y->sure, hull(x->near, y->near), hull(x->far, y->far)};
  Roots roots = x ? x : y;
  if (roots) roots->sure = false;
  return roots;
}

}  // namespace

RoundedSphere::RoundedSphere(const Triple<Interval>& O, const Triple<Interval>& center,
                             const Interval& r)
    : C(center),
      CO(O - center),
      r_squared(square(r)),
      c(squared_length(CO) - r_squared),
      c_factored((reference::length(CO) - r) * (reference::length(CO) + r)) {}

RoundedRay::RoundedRay(const Triple<Interval>& direction)
    : D(direction),
      a(squared_length(D)),
      length(sqrt(a)),
      unit_D{D[0] / length, D[1] / length, D[2] / length},
      unit_a(squared_length(unit_D)) {}

Roots possible_roots(const RoundedSphere& sphere, const RoundedRay& ray) {
  const Interval b = whole(ray.a, 2) * dot(sphere.CO, ray.D);
  const Interval unit_b = whole(ray.a, 2) * dot(sphere.CO, ray.unit_D);
  const Roots by_slides = quadratic_roots(ray.a, b, sphere.c);
  const Roots with_unit_D = divided(quadratic_roots(ray.unit_a, unit_b, sphere.c), ray.length);
  const Roots with_factors = quadratic_roots(ray.a, b, sphere.c_factored);
  const Roots by_distance = distance_roots(sphere, ray);
  return either(either(by_slides, with_unit_D), either(with_factors, by_distance));
}

}  // namespace fos::reference
