// Numbers a + b √s with rational a and b, all over the same s: exact.
//
// With s the discriminant of the sphere that a ray hits, t is one of them, and so is all that
// comes of it by sums and products: P, N, L, <N, L>, |L|².
#pragma once

#include <gmpxx.h>

#include "certified_light.hpp"
#include "triple.hpp"

namespace fos {

struct Surd {
  mpq_class a;
  mpq_class b;
};

/// The numbers over one s >= 0. Where √s is rational every b is 0, so that what is rational
/// shows.
class SurdField {
 public:
  explicit SurdField(mpq_class s);

  /// a + b √s
  Surd number(const mpq_class& a, const mpq_class& b) const;
  Surd product(const Surd& x, const Surd& y) const;
  Surd dot(const reference::Triple<Surd>& x, const reference::Triple<Surd>& y) const;

  /// -1, 0 or 1.
  int sign(const Surd& x) const;
  /// The number itself where it is rational, else to 2^-64 of itself at least.
  reference::Enclosure enclose(const Surd& x) const;

 private:
  mpq_class s_;
  bool has_root_;   ///< whether √s is rational
  mpq_class root_;  ///< then √s
};

inline Surd operator+(const Surd& x, const Surd& y) { return {x.a + y.a, x.b + y.b}; }
inline Surd operator-(const Surd& x, const Surd& y) { return {x.a - y.a, x.b - y.b}; }
inline Surd operator*(const mpq_class& x, const Surd& y) { return {x * y.a, x * y.b}; }

/// √x, exact where that is rational. `x` >= 0.
reference::Enclosure square_root(const reference::Enclosure& x);
/// x / y. `y` > 0.
reference::Enclosure quotient(const reference::Enclosure& x, const reference::Enclosure& y);
/// x y. `x` >= 0.
reference::Enclosure product(const mpq_class& x, const reference::Enclosure& y);
/// The angle with this cosine, in degrees: 0..180.
reference::Enclosure degrees(const reference::Enclosure& cosine);

}  // namespace fos
