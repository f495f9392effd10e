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
#pragma once

#include <optional>

#include "interval.hpp"
#include "triple.hpp"

namespace fos::reference {

/// A sphere as seen from the camera.
struct RoundedSphere {
  RoundedSphere(const Triple<Interval>& O, const Triple<Interval>& C, const Interval& r);

  Triple<Interval> C;
  Triple<Interval> CO;
  Interval r_squared;
  Interval c;           ///< CO . CO - r^2
  Interval c_factored;  ///< (|CO| - r) (|CO| + r)
};

/// A ray's direction, as it is and divided by its length.
struct RoundedRay {
  explicit RoundedRay(const Triple<Interval>& D);

  Triple<Interval> D;
  Interval a;  ///< D . D
  Interval length;
  Triple<Interval> unit_D;
  Interval unit_a;  ///< about 1
};

struct PossibleRoots {
  bool sure;  ///< all ways find them, whatever their roundings
  Interval near;
  Interval far;
};

/// Nothing if no way finds roots, whatever its roundings.
std::optional<PossibleRoots> possible_roots(const RoundedSphere& sphere, const RoundedRay& ray);

}  // namespace fos::reference
