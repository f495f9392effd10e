// Signs of numbers with square roots in them, decided exactly by squaring: no rounding, no epsilon.
#pragma once

#include <gmpxx.h>

namespace fos::reference {

/// sign * sqrt(radicand), with sign -1 or 1 and radicand >= 0.
struct Root {
  int sign;
  mpq_class radicand;
};

/// -1, 0 or 1: the sign of p + x.
int sign_of_sum(const mpq_class& p, const Root& x);

/// -1, 0 or 1: the sign of p + x + y.
int sign_of_sum(const mpq_class& p, const Root& x, const Root& y);

}  // namespace fos::reference
