// A stage's I as a set of terms, and the byte of a channel: both exact.
#pragma once

#include <gmpxx.h>

#include <array>

namespace fos::reference {

/// What a stage sums up to get I, combined with |. `flat` is the 1 of a picture without light.
enum Term : unsigned { flat = 1, ambient = 2, point = 4, directional = 8 };
using Terms = unsigned;

/// Every sum that a stage may ask for.
inline constexpr std::array<Terms, 8> all_terms{flat,
                                                ambient,
                                                point,
                                                directional,
                                                ambient | point,
                                                ambient | directional,
                                                point | directional,
                                                ambient | point | directional};

/// I, from I_A and the sums over the point and over the directional lights.
mpq_class intensity(Terms terms, const mpq_class& I_A, const mpq_class& point_sum,
                    const mpq_class& directional_sum);

/// The byte of a channel: clamped to 0..255, then rounded, half to even.
int to_byte(const mpq_class& channel);

}  // namespace fos::reference
