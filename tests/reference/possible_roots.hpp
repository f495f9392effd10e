// Where a ray may meet a sphere, as floating-point programs see it.
//
// There is more than one right way to the roots of the slides' quadratic, and where one of them is
// exact by good luck, another may round: at a tangent ray, or at round numbers. So four ways are
// evaluated in intervals, and what any of them may answer is right:
//   - the slides' a t^2 + b t + c = 0;
//   - the same with D divided by its length, and t divided by it afterwards;
//   - the same with c = (|CO| - r) (|CO| + r);
//   - with the discriminant from the ray's distance to the center, which does not cancel for far
//     and for small spheres (Haines et al., Ray Tracing Gems, 2019, chapter 7).
//
// A Number is an interval: Interval, or one of another make with the same operations.
#pragma once

#include <optional>

#include "interval.hpp"
#include "triple.hpp"

namespace fos::reference {

/// A sphere as seen from the camera.
template <class Number>
struct RoundedSphere {
  RoundedSphere(const Triple<Number>& O, const Triple<Number>& center, const Number& r)
      : C(center),
        CO(O - center),
        r_squared(square(r)),
        c(squared_length(CO) - r_squared),
        c_factored((reference::length(CO) - r) * (reference::length(CO) + r)) {}

  Triple<Number> C;
  Triple<Number> CO;
  Number r_squared;
  Number c;           ///< CO . CO - r^2
  Number c_factored;  ///< (|CO| - r) (|CO| + r)
};

/// A ray's direction, as it is and divided by its length.
template <class Number>
struct RoundedRay {
  explicit RoundedRay(const Triple<Number>& direction)
      : D(direction),
        a(squared_length(D)),
        length(sqrt(a)),
        unit_D{D[0] / length, D[1] / length, D[2] / length},
        unit_a(squared_length(unit_D)) {}

  Triple<Number> D;
  Number a;  ///< D . D
  Number length;
  Triple<Number> unit_D;
  Number unit_a;  ///< about 1
};

template <class Number>
struct PossibleRoots {
  bool sure;  ///< all ways find them, whatever their roundings
  Number near;
  Number far;
};

/// Of a t^2 + b t + c = 0, by the slides' formula.
template <class Number>
std::optional<PossibleRoots<Number>> quadratic_roots(const Number& a, const Number& b,
                                                     const Number& c) {
  const Number discriminant = square(b) - Number(a.bits(), 4) * a * c;
  if (discriminant.high_sign() < 0) return std::nullopt;
  const Number root = sqrt(without_negative(discriminant));
  const Number two_a = Number(a.bits(), 2) * a;
  return PossibleRoots<Number>{discriminant.low_sign() >= 0, (-b - root) / two_a,
                               (-b + root) / two_a};
}

/// The ray is nearest to the center at t = -h / a; there the center is -f away.
template <class Number>
std::optional<PossibleRoots<Number>> distance_roots(const RoundedSphere<Number>& sphere,
                                                    const RoundedRay<Number>& ray) {
  const Number nearest_t = -dot(sphere.CO, ray.D) / ray.a;
  const Triple<Number> f = sphere.CO + nearest_t * ray.D;
  const Number rest = sphere.r_squared - squared_length(f);
  if (rest.high_sign() < 0) return std::nullopt;
  const Number half_chord = sqrt(without_negative(rest) / ray.a);
  return PossibleRoots<Number>{rest.low_sign() >= 0, nearest_t - half_chord,
                               nearest_t + half_chord};
}

template <class Number>
std::optional<PossibleRoots<Number>> divided(const std::optional<PossibleRoots<Number>>& roots,
                                             const Number& length) {
  if (!roots) return std::nullopt;
  return PossibleRoots<Number>{roots->sure, roots->near / length, roots->far / length};
}

/// What either way may find.
template <class Number>
std::optional<PossibleRoots<Number>> either(const std::optional<PossibleRoots<Number>>& x,
                                            const std::optional<PossibleRoots<Number>>& y) {
  if (x && y) {
    return PossibleRoots<Number>{x->sure && y->sure, hull(x->near, y->near), hull(x->far, y->far)};
  }
  std::optional<PossibleRoots<Number>> roots = x ? x : y;
  if (roots) roots->sure = false;
  return roots;
}

/// Nothing if no way finds roots, whatever its roundings.
template <class Number>
std::optional<PossibleRoots<Number>> possible_roots(const RoundedSphere<Number>& sphere,
                                                    const RoundedRay<Number>& ray) {
  const Number two(ray.a.bits(), 2);
  const Number b = two * dot(sphere.CO, ray.D);
  const Number unit_b = two * dot(sphere.CO, ray.unit_D);
  const auto by_slides = quadratic_roots(ray.a, b, sphere.c);
  const auto with_unit_D = divided(quadratic_roots(ray.unit_a, unit_b, sphere.c), ray.length);
  const auto with_factors = quadratic_roots(ray.a, b, sphere.c_factored);
  const auto by_distance = distance_roots(sphere, ray);
  return either(either(by_slides, with_unit_D), either(with_factors, by_distance));
}

}  // namespace fos::reference
