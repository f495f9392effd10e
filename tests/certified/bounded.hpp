// A double and how far it may be from the exact number: a running error bound.
//
// Each operation rounds once, by at most 2^-53 of its result, and passes the errors of its operands
// on. `grow` covers the roundings of the bound itself, `tiny` every underflow. Where a bound is not
// finite, or a NaN has come in, nothing is certain: every comparison below is false.
#pragma once

#include <cmath>
#include <limits>

namespace fos::certified {

class Bounded {
 public:
  static constexpr double half_ulp = 0x1p-53;
  static constexpr double grow = 1 + 0x1p-49;
  static constexpr double tiny = 0x1p-1000;

  Bounded() = default;
  constexpr Bounded(double value, double error) : value_(value), error_(error) {}
  /// A whole number, or any other double that is meant exactly.
  static constexpr Bounded exactly(double value) { return {value, 0}; }
  /// A double within 2^-52 of its size of the exact number.
  static Bounded rounded(double value) { return {value, std::abs(value) * 0x1p-52 + tiny}; }

  double value() const { return value_; }
  /// The exact number is not below, and not above. (The roundings of two sums are in the slack.)
  double low() const { return value_ - (error_ * grow + std::abs(value_) * (4 * half_ulp)); }
  double high() const { return value_ + (error_ * grow + std::abs(value_) * (4 * half_ulp)); }

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return computed(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return computed(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return computed(a.value_ * b.value_, std::abs(a.value_) * b.error_ +
                                             std::abs(b.value_) * a.error_ + a.error_ * b.error_);
  }
  /// Nothing certain if b may be 0.
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const double quotient = a.value_ / b.value_;
    const double least = std::abs(b.value_) - b.error_ * grow;
    if (!(least > 0)) return {quotient, std::numeric_limits<double>::infinity()};
    return computed(quotient, (a.error_ + std::abs(quotient) * b.error_) / (least * (1 - 0x1p-52)));
  }
  friend Bounded operator-(const Bounded& a) { return {-a.value_, a.error_}; }
  /// The exact number is known not to be negative.
  friend Bounded sqrt(const Bounded& a) {
    if (!(a.value_ > 0)) return {0, std::sqrt(a.error_) * grow + tiny};
    const double root = std::sqrt(a.value_);
    return computed(root, a.error_ / root);
  }

 private:
  static Bounded computed(double value, double passed_on) {
    return {value, (passed_on + std::abs(value) * half_ulp) * grow + tiny};
  }

  double value_ = 0;
  double error_ = 0;
};

/// Whether a is certainly less than b.
inline bool is_less(const Bounded& a, const Bounded& b) { return a.high() < b.low(); }

}  // namespace fos::certified
