// From exact decimals to floating point, rounded once.
#pragma once

#include <fmt/core.h>

#include <charconv>
#include <glm/vec3.hpp>
#include <limits>
#include <string>

#include "fos/scene_text.hpp"

namespace fos {

/// The T nearest to an exact decimal; infinity or 0 where it lies outside T's range.
template <typename T>
T nearest(const Decimal& decimal) {
  if (decimal.is_zero()) return 0;
  const std::string text = fmt::format("{}e{}", decimal.digits, decimal.exponent);
  T value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range) {
    const bool large = static_cast<long>(decimal.digits.size()) + decimal.exponent > 0;
    value = large ? std::numeric_limits<T>::infinity() : 0;
  }
  return decimal.negative ? -value : value;
}

template <typename T>
glm::vec<3, T> nearest(const DecimalTriple& triple) {
  return {nearest<T>(triple[0]), nearest<T>(triple[1]), nearest<T>(triple[2])};
}

}  // namespace fos
