// Exact decimals: what a scene file writes, before any rounding.
#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "fos/scene_text.hpp"

namespace fos {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The digits at the front of `text`, taken off it.
std::string_view take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

long take_exponent(std::string_view& text) {
  const bool negative = !text.empty() && text.front() == '-';
  take(text, "+-");
  const std::string_view digits = take_digits(text);
  if (digits.empty()) throw std::invalid_argument("exponent");
  // Far beyond what any scene may have, and far from what a long cannot hold.
  constexpr long largest = 1'000'000'000;
  long value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (result.ec != std::errc() || value > largest) value = largest;
  return negative ? -value : value;
}

/// How many powers of ten the first digit stands for: 0.1 -> 0, 1 -> 1, 10 -> 2.
long magnitude(const Decimal& value) {
  return static_cast<long>(value.digits.size()) + value.exponent;
}

}  // namespace

Decimal parse_decimal(std::string_view text) {
  Decimal value;
  value.text = text;
  value.negative = text.starts_with('-');
  take(text, "+-");
  const std::string_view whole = take_digits(text);
  const std::string_view fraction = take(text, ".") ? take_digits(text) : std::string_view();
  if (whole.empty() && fraction.empty()) throw std::invalid_argument("digits");
  if (take(text, "eE")) value.exponent = take_exponent(text);
  if (!text.empty()) throw std::invalid_argument("rest");

  value.digits = std::string(whole) + std::string(fraction);
  value.exponent -= static_cast<long>(fraction.size());
  value.digits.erase(0, value.digits.find_first_not_of('0'));
  const std::size_t last = value.digits.find_last_not_of('0');
  if (last == std::string::npos) {  // zero
    value.digits.clear();
    value.exponent = 0;
    value.negative = false;
  } else {
    value.exponent += static_cast<long>(value.digits.size() - 1 - last);
    value.digits.erase(last + 1);
  }
  return value;
}

int compare(const Decimal& a, const Decimal& b) {
  const auto sign = [](const Decimal& d) { return d.is_zero() ? 0 : d.negative ? -1 : 1; };
  if (sign(a) != sign(b)) return sign(a) < sign(b) ? -1 : 1;
  if (a.is_zero()) return 0;
  if (magnitude(a) != magnitude(b)) return (magnitude(a) < magnitude(b) ? -1 : 1) * sign(a);
  // Same magnitude, so the digits line up from the left, and a missing one is a zero.
  const int order = a.digits.compare(b.digits);
  return (order < 0 ? -1 : order > 0 ? 1 : 0) * sign(a);
}

}  // namespace fos
