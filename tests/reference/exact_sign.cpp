#include "exact_sign.hpp"

namespace fos::reference {
namespace {

int sign_of(const Root& x) { return sgn(x.radicand) == 0 ? 0 : x.sign; }

}  // namespace

int sign_of_sum(const mpq_class& p, const Root& x) {
  const int p_sign = sgn(p);
  const int x_sign = sign_of(x);
  if (p_sign == 0 || x_sign == p_sign) return x_sign;
  if (x_sign == 0) return p_sign;
  // Of opposite signs: the one with the larger square wins.
  const mpq_class p_squared = p * p;
  return p_sign * sgn(mpq_class(p_squared - x.radicand));
}

int sign_of_sum(const mpq_class& p, const Root& x, const Root& y) {
  // The sign of x + y, by the same rule.
  const int x_sign = sign_of(x);
  const int y_sign = sign_of(y);
  const int roots_sign = x_sign == 0 || x_sign == y_sign ? y_sign
                         : y_sign == 0                   ? x_sign
                                       : x_sign * sgn(mpq_class(x.radicand - y.radicand));
  const int p_sign = sgn(p);
  if (p_sign == 0 || roots_sign == p_sign) return roots_sign;
  if (roots_sign == 0) return p_sign;
  // Of opposite signs: compare p^2 with (x + y)^2 = x^2 + y^2 + 2xy, where 2xy is again a root.
  const mpq_class difference = p * p - x.radicand - y.radicand;
  const mpq_class product = 4 * x.radicand * y.radicand;
  return p_sign * sign_of_sum(difference, Root{-x.sign * y.sign, product});
}

}  // namespace fos::reference
