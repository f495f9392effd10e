// Intervals whose ends are numbers of the machine, rounded outward: while no end leaves the range
// of Real they are bit for bit those that reference::Interval has at the same number of bits.
//
// All arithmetic rounds up, and an interval keeps the negative of its low end, so that rounding up
// rounds outward at both ends. So whatever computes with intervals
//   - is called while a RoundUp lives, and stands in a file of its own, so that no compiler can
//   move
//     arithmetic out of it;
//   - is compiled to round as the machine is told: the target fos_directed_rounding.
//
// The machine notes overflow, underflow that rounds, and what has no result; division by an
// interval that holds 0 is noted too. RoundUp says whether there was any. If there was, the
// intervals mean nothing.
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <algorithm>
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <limits>

#if FLT_EVAL_METHOD != 0
#error "float and double must be computed as what they are (-mfpmath=sse -msse2)"
#endif

namespace fos::certified {

/// While it lives, this thread's arithmetic rounds up.
class RoundUp {
 public:
  RoundUp() : mode_(std::fegetround()) {
    std::fesetround(FE_UPWARD);
    start();
  }
  RoundUp(const RoundUp&) = delete;
  RoundUp& operator=(const RoundUp&) = delete;
  ~RoundUp() { std::fesetround(mode_); }

  /// Forgets what has happened so far.
  static void start() {
    if (!is_in_range()) std::feclearexcept(out_of_range);
  }
  /// Whether since then every result was in range.
  static bool is_in_range() { return std::fetestexcept(out_of_range) == 0; }

 private:
  static constexpr int out_of_range = FE_OVERFLOW | FE_UNDERFLOW | FE_INVALID | FE_DIVBYZERO;
  int mode_;
};

template <class Real>
class HardwareInterval {
 public:
  static constexpr int digits = std::numeric_limits<Real>::digits;

  /// The narrowest around a number. `bits` are `digits`: reference::Interval is told them too.
  HardwareInterval(mpfr_prec_t bits, const mpq_class& exact);
  HardwareInterval(mpfr_prec_t /*bits*/, int exact)
      : minus_low_(-static_cast<Real>(exact)), high_(static_cast<Real>(exact)) {}
  static HardwareInterval between(Real low, Real high) { return {-low, high}; }
  static HardwareInterval exactly(Real x) { return {-x, x}; }
  /// The narrowest around intervals of more digits.
  template <class Wider>
  static HardwareInterval around(const HardwareInterval<Wider>& x) {
    return {static_cast<Real>(-x.low()), static_cast<Real>(x.high())};
  }

  static constexpr mpfr_prec_t bits() { return digits; }
  Real low() const { return -minus_low_; }
  Real high() const { return high_; }
  /// One that is not is out of range.
  static constexpr bool is_bounded() { return true; }
  int low_sign() const { return (low() > 0) - (low() < 0); }
  int high_sign() const { return (high_ > 0) - (high_ < 0); }
  bool is_zero() const { return minus_low_ == 0 && high_ == 0; }
  bool is_below(int x) const { return high_ < static_cast<Real>(x); }
  bool is_at_least(int x) const { return low() >= static_cast<Real>(x); }
  friend int compare_ends(const HardwareInterval& a, const HardwareInterval& b) {
    return (a.high_ > b.low()) - (a.high_ < b.low());
  }

  friend HardwareInterval operator+(const HardwareInterval& a, const HardwareInterval& b) {
    return {a.minus_low_ + b.minus_low_, a.high_ + b.high_};
  }
  friend HardwareInterval operator-(const HardwareInterval& a, const HardwareInterval& b) {
    return {a.minus_low_ + b.high_, a.high_ + b.minus_low_};
  }
  friend HardwareInterval operator-(const HardwareInterval& a) { return {a.high_, a.minus_low_}; }
  friend HardwareInterval operator*(const HardwareInterval& a, const HardwareInterval& b) {
    if (a.minus_low_ <= 0 && b.minus_low_ <= 0) {
      return {a.minus_low_ * b.low(), a.high_ * b.high_};
    }
    // Each end is that of a product of ends.
    return {max_of(a.minus_low_ * b.low(), a.minus_low_ * b.high_, a.high_ * b.minus_low_,
                   -a.high_ * b.high_),
            max_of(a.minus_low_ * b.minus_low_, a.low() * b.high_, a.high_ * b.low(),
                   a.high_ * b.high_)};
  }
  friend HardwareInterval operator/(const HardwareInterval& a, const HardwareInterval& b) {
    if (b.minus_low_ < 0) return divided_by_positive(a, b);
    if (b.high_ < 0) return divided_by_positive(-a, -b);
    std::feraiseexcept(FE_DIVBYZERO);
    return a;
  }
  friend HardwareInterval square(const HardwareInterval& a) {
    if (a.minus_low_ <= 0) return {a.minus_low_ * a.low(), a.high_ * a.high_};
    if (a.high_ <= 0) return {-a.high_ * a.high_, a.minus_low_ * a.minus_low_};
    return {0, max_of(a.minus_low_ * a.minus_low_, a.high_ * a.high_)};
  }
  /// `a` >= 0.
  friend HardwareInterval sqrt(const HardwareInterval& a) {
    const Real low = a.low();
    return {minus_sqrt(low, std::sqrt(low)), std::sqrt(a.high_)};
  }
  /// The part of `a` that is >= 0; `a` must have one.
  friend HardwareInterval without_negative(const HardwareInterval& a) {
    return {std::min(a.minus_low_, Real{0}), a.high_};
  }
  /// The smallest interval that holds both.
  friend HardwareInterval hull(const HardwareInterval& a, const HardwareInterval& b) {
    return {max_of(a.minus_low_, b.minus_low_), max_of(a.high_, b.high_)};
  }
  /// All that the larger, or the smaller, of two numbers can be.
  friend HardwareInterval max(const HardwareInterval& a, const HardwareInterval& b) {
    return {std::min(a.minus_low_, b.minus_low_), max_of(a.high_, b.high_)};
  }
  friend HardwareInterval min(const HardwareInterval& a, const HardwareInterval& b) {
    return {max_of(a.minus_low_, b.minus_low_), std::min(a.high_, b.high_)};
  }

 private:
  HardwareInterval(Real minus_low, Real high) : minus_low_(minus_low), high_(high) {}

  static Real max_of(Real x, Real y) { return x < y ? y : x; }
  static Real max_of(Real x, Real y, Real z, Real w) { return max_of(max_of(x, y), max_of(z, w)); }

  static HardwareInterval divided_by_positive(const HardwareInterval& a,
                                              const HardwareInterval& b) {
    return {a.minus_low_ / (a.minus_low_ > 0 ? b.low() : b.high_),
            a.high_ / (a.high_ > 0 ? b.low() : b.high_)};
  }
  /// -sqrt(x), where `root` is the root rounded up: that is it if its square is x, and else the
  /// root is between it and the number below. (Rounded up, a square is not x unless it is exact.)
  static Real minus_sqrt(Real x, Real root) {
    return root * root == x ? -root : std::numeric_limits<Real>::min() - root;
  }

  Real minus_low_;
  Real high_;
};

extern template HardwareInterval<float>::HardwareInterval(mpfr_prec_t, const mpq_class&);
extern template HardwareInterval<double>::HardwareInterval(mpfr_prec_t, const mpq_class&);
extern template HardwareInterval<long double>::HardwareInterval(mpfr_prec_t, const mpq_class&);

}  // namespace fos::certified
