// How a channel becomes a byte, for every number type: also where there is no more than the
// language, as in a browser.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>

namespace fos {

/// THE byte rule: round half to even of clamp(channel, 0, 255). `channel` is not NaN.
template <std::floating_point T>
std::uint8_t nearest_byte(T channel) {
  // In steps that are exact in any T, and many times faster than nearbyint.
  const T clamped = std::clamp(channel, T(0), T(255));
  const int below = static_cast<int>(clamped);
  const T rest = clamped - static_cast<T>(below);
  const bool up = rest > T(0.5) || (rest == T(0.5) && below % 2 == 1);
  return static_cast<std::uint8_t>(up ? below + 1 : below);
}

/// What is shown where a channel is NaN or infinite: magenta.
inline constexpr std::array<std::uint8_t, 3> not_finite_color{255, 0, 255};

}  // namespace fos
