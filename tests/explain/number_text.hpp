// Exact and enclosed numbers in decimals of which every digit is right.
#pragma once

#include <string>

#include "certified_light.hpp"

namespace fos {

inline constexpr int shown_digits = 7;

/// The number rounded to so many significant digits, half to even: `0.08333333`, `-2.4e-9`,
/// without the zeros at its end. `digits` >= 1.
std::string decimal_text(const mpq_class& x, int digits = shown_digits);
/// The same of a program's number; `NaN`, `inf`.
std::string decimal_text(long double x, int digits = shown_digits);

/// The number that is enclosed, correctly rounded; with fewer digits where the enclosure
/// decides only those. Zeros at the end are dropped only where the number ends there: `2.4`
/// is exact, `2.400000` is rounded. `digits` >= 1.
std::string decimal_text(const reference::Enclosure& x, int digits = shown_digits);

/// `(x, y, z)`.
template <class Triple>
std::string triple_text(const Triple& x, int digits = shown_digits) {
  return "(" + decimal_text(x[0], digits) + ", " + decimal_text(x[1], digits) + ", " +
         decimal_text(x[2], digits) + ")";
}

}  // namespace fos
