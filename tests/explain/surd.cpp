#include "surd.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "exact_sign.hpp"

namespace fos {
namespace {

using reference::Enclosure;
using reference::Interval;

constexpr mpfr_prec_t working_bits = 256;

std::optional<mpq_class> rational_root(const mpq_class& x) {
  if (!mpz_perfect_square_p(x.get_num_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) {
    return std::nullopt;
  }
  return mpq_class(sqrt(x.get_num()), sqrt(x.get_den()));
}

bool is_narrow(const Enclosure& x) {
  const mpq_class size = std::min(mpq_class(abs(x.low)), mpq_class(abs(x.high)));
  return (x.high - x.low) * (mpz_class(1) << 64U) <= size;
}

}  // namespace

SurdField::SurdField(mpq_class s) : s_(std::move(s)) {
  const std::optional<mpq_class> root = rational_root(s_);
  has_root_ = root.has_value();
  if (root) root_ = *root;
}

Surd SurdField::number(const mpq_class& a, const mpq_class& b) const {
  if (has_root_) return {mpq_class(a + b * root_), 0};
  return {a, b};
}

Surd SurdField::product(const Surd& x, const Surd& y) const {
  return {x.a * y.a + x.b * y.b * s_, x.a * y.b + x.b * y.a};
}

Surd SurdField::dot(const reference::Triple<Surd>& x, const reference::Triple<Surd>& y) const {
  return product(x[0], y[0]) + product(x[1], y[1]) + product(x[2], y[2]);
}

int SurdField::sign(const Surd& x) const {
  return reference::sign_of_sum(x.a, {sgn(x.b) < 0 ? -1 : 1, mpq_class(x.b * x.b * s_)});
}

Enclosure SurdField::enclose(const Surd& x) const {
  if (sgn(x.b) == 0) return {x.a, x.a};
  // b √s is irrational, so that x is not 0, and enough bits tell it from 0.
  for (mpfr_prec_t bits = working_bits;; bits *= 2) {
    const Interval value = Interval(bits, x.a) + Interval(bits, x.b) * sqrt(Interval(bits, s_));
    Enclosure enclosure{value.exact_low(), value.exact_high()};
    if (is_narrow(enclosure)) return enclosure;
  }
}

Enclosure square_root(const Enclosure& x) {
  if (x.low == x.high) {
    if (const std::optional<mpq_class> root = rational_root(x.low)) return {*root, *root};
  }
  return {sqrt(Interval(working_bits, x.low)).exact_low(),
          sqrt(Interval(working_bits, x.high)).exact_high()};
}

Enclosure quotient(const Enclosure& x, const Enclosure& y) {
  return {x.low / (sgn(x.low) < 0 ? y.low : y.high), x.high / (sgn(x.high) < 0 ? y.high : y.low)};
}

Enclosure product(const mpq_class& x, const Enclosure& y) { return {x * y.low, x * y.high}; }

Enclosure degrees(const Enclosure& cosine) {
  // acos falls, and both factors are >= 0: each end by its own rounding.
  const auto end = [](const mpq_class& cos, mpfr_rnd_t round) {
    const mpfr_rnd_t opposite = round == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
    mpfr_t angle;
    mpfr_t half_turn;
    mpfr_inits2(working_bits, angle, half_turn, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_q(angle, cos.get_mpq_t(), opposite);
    // Rounding may have left [-1, 1] behind.
    if (mpfr_cmp_si(angle, 1) > 0) mpfr_set_si(angle, 1, MPFR_RNDN);
    if (mpfr_cmp_si(angle, -1) < 0) mpfr_set_si(angle, -1, MPFR_RNDN);
    mpfr_acos(angle, angle, round);
    mpfr_const_pi(half_turn, opposite);
    mpfr_mul_ui(angle, angle, 180, round);
    mpfr_div(angle, angle, half_turn, round);
    mpq_class result;
    mpfr_get_q(result.get_mpq_t(), angle);
    mpfr_clears(angle, half_turn, static_cast<mpfr_ptr>(nullptr));
    return result;
  };
  return {end(cosine.high, MPFR_RNDD), end(cosine.low, MPFR_RNDU)};
}

}  // namespace fos
