// The light terms that are rational numbers: no interval, however narrow, can tell whether a color
// that is exactly between two bytes is just that.
#pragma once

#include <gmpxx.h>

#include <optional>

#include "exact_hit.hpp"
#include "exact_scene.hpp"

namespace fos::reference {

/// I <N, L> / (|N| |L|) at the hit, with N = P - C, if it is 0 or if P and the cosine are rational;
/// 0 for a light at P itself. Nothing for the other terms, which intervals decide.
std::optional<mpq_class> rational_term(const ExactScene& scene, const Triple<mpq_class>& D,
                                       const ExactHit& hit, const ExactLight& light);

}  // namespace fos::reference
