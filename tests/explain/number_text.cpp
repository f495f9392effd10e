#include "number_text.hpp"

#include <cmath>
#include <cstdlib>

namespace fos {
namespace {

mpq_class power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent)));
  return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}

/// A number as ±0.d1d2d3… 10^(exponent + 1), d1 not 0.
struct Rounded {
  bool negative = false;
  std::string digits;
  long exponent = 0;

  friend bool operator==(const Rounded&, const Rounded&) = default;
};

/// `x` is not 0.
Rounded rounded(const mpq_class& x, int digits) {
  const mpq_class size = abs(x);
  long exponent = static_cast<long>(mpz_sizeinbase(size.get_num_mpz_t(), 10)) -
                  static_cast<long>(mpz_sizeinbase(size.get_den_mpz_t(), 10)) - 2;
  while (size >= power_of_ten(exponent + 1)) ++exponent;
  const mpq_class scaled = size * power_of_ten(digits - 1 - exponent);
  mpz_class whole = scaled.get_num() / scaled.get_den();
  const int half = cmp(mpq_class(2 * (scaled - whole)), 1);
  if (half > 0 || (half == 0 && mpz_odd_p(whole.get_mpz_t()) != 0)) whole += 1;
  std::string text = whole.get_str();
  if (text.size() > static_cast<std::size_t>(digits)) {  // 9.99… became 10
    text.pop_back();
    ++exponent;
  }
  return {sgn(x) < 0, text, exponent};
}

mpq_class value(const Rounded& x) {
  const mpq_class size =
      mpz_class(x.digits) * power_of_ten(x.exponent + 1 - static_cast<long>(x.digits.size()));
  return x.negative ? mpq_class(-size) : size;
}

std::string text(Rounded x, bool trim) {
  constexpr long largest_plain = shown_digits;
  constexpr long smallest_plain = -5;
  if (trim) x.digits.erase(x.digits.find_last_not_of('0') + 1);
  std::string out = x.negative ? "-" : "";
  const bool plain = smallest_plain < x.exponent && x.exponent < largest_plain;
  if (plain && x.exponent < 0) {
    return out + "0." + std::string(static_cast<std::size_t>(-x.exponent - 1), '0') + x.digits;
  }
  const std::size_t before = plain ? static_cast<std::size_t>(x.exponent) + 1 : 1;
  if (x.digits.size() < before) x.digits.append(before - x.digits.size(), '0');
  out += x.digits.substr(0, before);
  if (x.digits.size() > before) out += "." + x.digits.substr(before);
  return plain ? out : out + "e" + std::to_string(x.exponent);
}

}  // namespace

std::string decimal_text(const mpq_class& x, int digits) {
  return sgn(x) == 0 ? "0" : text(rounded(x, digits), true);
}

std::string decimal_text(long double x, int digits) {
  if (std::isnan(x)) return "NaN";
  if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
  return decimal_text(mpq_class(static_cast<double>(x)), digits);
}

std::string decimal_text(const reference::Enclosure& x, int digits) {
  if (x.low == x.high) {
    if (sgn(x.low) == 0) return "0";
    const Rounded exact = rounded(x.low, digits);
    return text(exact, value(exact) == x.low);
  }
  if (sgn(x.low) * sgn(x.high) > 0) {
    for (int fewer = digits; fewer > 0; --fewer) {
      const Rounded low = rounded(x.low, fewer);
      if (low == rounded(x.high, fewer)) return text(low, false);
    }
  }
  return "[" + decimal_text(x.low, 2) + ", " + decimal_text(x.high, 2) + "]";
}

}  // namespace fos
