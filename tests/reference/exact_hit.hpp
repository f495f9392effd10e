// Which sphere a ray hits first, decided in exact arithmetic.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>

#include "exact_scene.hpp"

namespace fos::reference {

/// A root of the slides' quadratic a t^2 + b t + c = 0: t = (-b + sign * sqrt(discriminant)) /
/// (2a).
struct ExactRoot {
  mpq_class a;
  mpq_class b;
  mpq_class discriminant;  ///< b^2 - 4ac >= 0
  int sign;                ///< -1: the near root, 1: the far one
};

struct ExactHit {
  int sphere;  ///< its number in the scene, from 0
  ExactRoot root;
};

/// D of a pixel's ray: (x Vw / W, y Vh / H, d), not normalised.
Triple<mpq_class> exact_direction(const ExactScene& scene, int column, int row);

/// The sphere with the smallest t >= 1 along the ray O + t D from the camera; of two with the same
/// t the first in the scene. A ray with discriminant 0 hits.
std::optional<ExactHit> exact_hit(const ExactScene& scene, const Triple<mpq_class>& D);

/// The same, where only some of the spheres can be it: their numbers, rising.
std::optional<ExactHit> exact_hit(const ExactScene& scene, const Triple<mpq_class>& D,
                                  std::span<const int> spheres);

/// Whether the root is exactly t.
bool is_at(const ExactRoot& root, const mpq_class& t);

}  // namespace fos::reference
