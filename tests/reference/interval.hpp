// Intervals with MPFI: every operation's result contains all results for operands in its operands.
//
// Each interval has its own precision in bits; an operation's result has that of its left operand,
// and its ends are rounded outward.
#pragma once

#include <gmpxx.h>
#include <mpfi.h>
#include <mpfr.h>

#include <algorithm>
#include <utility>

namespace fos::reference {

class Interval {
 public:
  /// [0, 0]; `bits` >= 2.
  explicit Interval(mpfr_prec_t bits) {
    mpfi_init2(value_, bits);
    mpfi_set_ui(value_, 0);
  }
  Interval(mpfr_prec_t bits, const mpq_class& exact) {
    mpfi_init2(value_, bits);
    mpfi_set_q(value_, exact.get_mpq_t());
  }
  Interval(mpfr_prec_t bits, int exact) {
    mpfi_init2(value_, bits);
    mpfi_set_si(value_, exact);
  }
  Interval(const Interval& other) {
    mpfi_init2(value_, other.bits());
    mpfi_set(value_, other.value_);
  }
  Interval(Interval&& other) noexcept : Interval(other.bits()) { mpfi_swap(value_, other.value_); }
  Interval& operator=(Interval other) noexcept {
    mpfi_swap(value_, other.value_);
    return *this;
  }
  ~Interval() { mpfi_clear(value_); }

  mpfr_prec_t bits() const { return mpfi_get_prec(value_); }
  mpfr_srcptr low() const { return &value_->left; }
  mpfr_srcptr high() const { return &value_->right; }

  /// False after a division by an interval that holds 0.
  bool is_bounded() const { return mpfi_bounded_p(value_) != 0; }
  /// The signs of the ends: -1, 0 or 1. Only for bounded intervals.
  int low_sign() const { return mpfr_sgn(low()); }
  int high_sign() const { return mpfr_sgn(high()); }
  bool is_zero() const { return low_sign() == 0 && high_sign() == 0; }
  bool holds_zero() const { return low_sign() <= 0 && high_sign() >= 0; }
  /// Whether all of it is below a number, or none of it.
  bool is_below(unsigned x) const { return mpfr_cmp_ui(high(), x) < 0; }
  bool is_at_least(unsigned x) const { return mpfr_cmp_ui(low(), x) >= 0; }
  /// The sign of a's high end less b's low end: where it is negative, all of a is below b.
  friend int compare_ends(const Interval& a, const Interval& b) {
    return mpfr_cmp(a.high(), b.low());
  }

  /// The ends as exact numbers. Only for bounded intervals.
  mpq_class exact_low() const { return exact(low()); }
  mpq_class exact_high() const { return exact(high()); }

  friend Interval operator+(const Interval& a, const Interval& b) { return binary(mpfi_add, a, b); }
  friend Interval operator-(const Interval& a, const Interval& b) { return binary(mpfi_sub, a, b); }
  friend Interval operator*(const Interval& a, const Interval& b) { return binary(mpfi_mul, a, b); }
  friend Interval operator/(const Interval& a, const Interval& b) { return binary(mpfi_div, a, b); }
  friend Interval operator-(const Interval& a) { return unary(mpfi_neg, a); }
  friend Interval square(const Interval& a) { return unary(mpfi_sqr, a); }
  /// `a` >= 0.
  friend Interval sqrt(const Interval& a) { return unary(mpfi_sqrt, a); }

  /// The part of `a` that is >= 0; `a` must have one.
  friend Interval without_negative(Interval a) {
    if (a.low_sign() < 0) mpfr_set_zero(&a.value_->left, 1);
    return a;
  }
  /// The smallest interval that holds both.
  friend Interval hull(const Interval& a, const Interval& b) { return binary(mpfi_union, a, b); }

 private:
  template <class Operation>
  static Interval binary(Operation operation, const Interval& a, const Interval& b) {
    Interval result(a.bits());
    operation(result.value_, a.value_, b.value_);
    return result;
  }
  template <class Operation>
  static Interval unary(Operation operation, const Interval& a) {
    Interval result(a.bits());
    operation(result.value_, a.value_);
    return result;
  }
  static mpq_class exact(mpfr_srcptr end) {
    mpq_class result;
    mpfr_get_q(result.get_mpq_t(), end);
    return result;
  }

  mpfi_t value_;
};

}  // namespace fos::reference
