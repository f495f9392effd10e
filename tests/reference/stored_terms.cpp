#include "stored_terms.hpp"

#include <algorithm>

namespace fos::reference {
namespace {

/// A width of 2^60 steps is far more than any term: it would judge nothing.
constexpr std::size_t max_width_exponent = 60;

mpz_class floor(const mpq_class& x) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

}  // namespace

mpq_class times_power_of_two(const mpq_class& x, int exponent) {
  mpq_class result;
  if (exponent < 0) {
    mpq_div_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  } else {
    mpq_mul_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  }
  return result;
}

std::int64_t to_multiple(const mpq_class& x, int step) {
  return floor(times_power_of_two(x, -step) + mpq_class(1, 2)).get_si();
}

mpq_class from_multiple(std::int64_t multiple, int step) {
  return times_power_of_two(mpq_class(static_cast<signed long>(multiple)), step);
}

mpq_class term_width(const Interval& enclosure, const Enclosure& exact, const mpq_class& least) {
  const mpq_class below = exact.high - enclosure.exact_low();
  const mpq_class above = enclosure.exact_high() - exact.low;
  const mpq_class width = std::max({below, above, least});
  // exact + margin * width <= 0 gives 0; on the way there the term's width shrinks with the part
  // of the enclosure that is positive.
  const mpq_class of_the_positive_part = width + exact.high / mpq_class(margin);
  return std::max(mpq_class(0), std::min(width, of_the_positive_part));
}

std::optional<std::uint8_t> width_code(const mpq_class& width, int step) {
  if (width == 0) return std::uint8_t{0};
  // The smallest w >= 1 with width + 2^(step - 1) <= 2^(step + w - 1).
  const mpq_class steps = times_power_of_two(width, -step) + mpq_class(1, 2);
  const mpz_class rounded_up_less_one = -floor(-steps) - 1;
  const std::size_t exponent =
      rounded_up_less_one <= 0 ? 0 : mpz_sizeinbase(rounded_up_less_one.get_mpz_t(), 2);
  if (exponent > max_width_exponent) return std::nullopt;
  return static_cast<std::uint8_t>(exponent + 1);
}

}  // namespace fos::reference
