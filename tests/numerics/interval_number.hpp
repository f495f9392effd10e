// Intervals of doubles: the result of every operation holds all results for numbers in its
// operands.
//
// They are right only while the processor rounds upward (class RoundUpward), and in files that are
// compiled with -frounding-math. The lower end is kept negated, so that rounding upward rounds it
// outward too and the rounding is never switched.
#pragma once

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>

namespace fos::numerics {

class RoundUpward {
 public:
  RoundUpward() : before_(std::fegetround()) { std::fesetround(FE_UPWARD); }
  ~RoundUpward() { std::fesetround(before_); }
  RoundUpward(const RoundUpward&) = delete;
  RoundUpward& operator=(const RoundUpward&) = delete;

 private:
  int before_;
};

class IntervalNumber {
 public:
  IntervalNumber() = default;
  IntervalNumber(double exact) : minus_low_(-exact), high_(exact) {}
  IntervalNumber(double low, double high) : minus_low_(-low), high_(high) {}

  double low() const { return -minus_low_; }
  double high() const { return high_; }
  bool is_finite() const { return std::isfinite(minus_low_) && std::isfinite(high_); }

  friend IntervalNumber operator-(IntervalNumber a) { return negated_low(a.high_, a.minus_low_); }
  friend IntervalNumber operator+(IntervalNumber a, IntervalNumber b) {
    return negated_low(a.minus_low_ + b.minus_low_, a.high_ + b.high_);
  }
  friend IntervalNumber operator-(IntervalNumber a, IntervalNumber b) {
    return negated_low(a.minus_low_ + b.high_, a.high_ + b.minus_low_);
  }
  friend IntervalNumber operator*(IntervalNumber a, IntervalNumber b) {
    // The products of the ends, and their negatives rounded upward as well.
    const double aH = a.high_, aL = -a.minus_low_, bH = b.high_, bL = -b.minus_low_;
    return negated_low(largest(a.minus_low_ * bL, a.minus_low_ * bH, -aH * bL, -aH * bH),
                       largest(aL * bL, aL * bH, aH * bL, aH * bH));
  }
  /// All numbers where `b` holds 0.
  friend IntervalNumber operator/(IntervalNumber a, IntervalNumber b) {
    const double aH = a.high_, aL = -a.minus_low_, bH = b.high_, bL = -b.minus_low_;
    if (!(bL > 0) && !(bH < 0)) return all();
    return negated_low(largest(a.minus_low_ / bL, a.minus_low_ / bH, -aH / bL, -aH / bH),
                       largest(aL / bL, aL / bH, aH / bL, aH / bH));
  }
  friend IntervalNumber square(IntervalNumber a) {
    const double near = std::max({0.0, -a.minus_low_, -a.high_});
    const double far = std::max(a.minus_low_, a.high_);
    return negated_low(-near * near, far * far);
  }
  /// Of the part that is >= 0.
  friend IntervalNumber sqrt(IntervalNumber a) {
    const double above = std::sqrt(std::max(-a.minus_low_, 0.0));  // at most one step too high
    return {above > 0 ? std::nextafter(above, 0.0) : 0, std::sqrt(a.high_)};
  }
  /// What max(0, x) gives.
  friend IntervalNumber positive_part(IntervalNumber a) {
    return negated_low(std::min(a.minus_low_, 0.0), std::max(a.high_, 0.0));
  }
  static IntervalNumber all() {
    return negated_low(std::numeric_limits<double>::infinity(),
                       std::numeric_limits<double>::infinity());
  }

 private:
  static IntervalNumber negated_low(double minus_low, double high) {
    IntervalNumber result;
    result.minus_low_ = minus_low;
    result.high_ = high;
    return result;
  }
  /// Of products 0 · ∞ there is no number: then the interval has no end.
  static double largest(double a, double b, double c, double d) {
    const double sum = a + b + c + d;  // NaN where one is, or where ∞ meets −∞
    if (std::isnan(sum)) return std::numeric_limits<double>::infinity();
    return std::max(std::max(a, b), std::max(c, d));
  }

  double minus_low_ = 0;
  double high_ = 0;
};

}  // namespace fos::numerics
