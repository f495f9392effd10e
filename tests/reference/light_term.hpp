// The slides' light term at a root that is known exactly, in intervals of any make and precision.
#pragma once

#include "triple.hpp"

namespace fos::reference {

/// The point at t = (-b + sign * sqrt(discriminant)) / (2a), and its normal.
template <class Number>
struct HitPoint {
  Triple<Number> P;
  Triple<Number> N;  ///< P - C
};

/// The ray O + t D and the center C of the sphere that it hits.
template <class Number>
HitPoint<Number> hit_point(const Triple<Number>& O, const Triple<Number>& D,
                           const Triple<Number>& C, const Number& minus_b,
                           const Number& discriminant, int sign, const Number& two_a) {
  const Number root = sqrt(discriminant);
  const Number t = (sign < 0 ? minus_b - root : minus_b + root) / two_a;
  const Triple<Number> P = O + t * D;
  return {P, P - C};
}

/// I <N, L> / (|N| |L|), negative ones too. |N| = r, for P is on the sphere. `vector` is a point
/// light's position, or the L of a directional one.
template <class Number>
Number light_term(const HitPoint<Number>& hit, const Number& r, const Number& I, bool is_point,
                  const Triple<Number>& vector) {
  const Triple<Number> L = is_point ? vector - hit.P : vector;
  return I * dot(hit.N, L) / (r * length(L));
}

}  // namespace fos::reference
