// The light at an exactly known hit, enclosed as tightly as is asked.
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <optional>
#include <vector>

#include "exact_hit.hpp"
#include "exact_scene.hpp"

namespace fos::reference {

/// A number that is not less than `low`, and not more than `high`.
struct Enclosure {
  mpq_class low;
  mpq_class high;
};

/// For each light of the scene the enclosure of I_i <N, L_i> / (|N| |L_i|), negative ones too, with
/// N = P - C; a rational one is exact. A light at P itself gives 0. Nothing if `bits` are too few.
std::optional<std::vector<Enclosure>> certified_terms(const ExactScene& scene,
                                                      const Triple<mpq_class>& D,
                                                      const ExactHit& hit, mpfr_prec_t bits);

struct TermSums {
  Enclosure point;
  Enclosure directional;
};

/// The sums over the lights of a kind, a negative term as 0.
TermSums sum_terms(const ExactScene& scene, const std::vector<Enclosure>& terms);

}  // namespace fos::reference
