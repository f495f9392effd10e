#include "shade.hpp"

#include <algorithm>
#include <cmath>

namespace fos {
namespace {

bool is_cut_off(const Channels& channels) {
  return std::any_of(channels.begin(), channels.end(), [](double c) { return c >= 255; });
}

/// I by the color's brightest channel, which shows it best.
double estimate(const Channels& color, const Channels& channels) {
  const auto brightest =
      static_cast<std::size_t>(std::max_element(color.begin(), color.end()) - color.begin());
  return color[brightest] > 0 ? channels[brightest] / color[brightest] : 0;
}

}  // namespace

bool is_shade(const Channels& color, const Channels& channels) {
  // Where a channel is cut off, the others may have any light that is strong enough for that.
  if (is_cut_off(channels)) return true;
  const double I = estimate(color, channels);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(channels[i] - color[i] * I) > 0.01 + 1e-3 * channels[i]) return false;
  }
  return true;
}

std::optional<double> light_of(const Channels& color, const Channels& channels) {
  if (is_cut_off(channels) || !is_shade(color, channels)) return std::nullopt;
  return estimate(color, channels);
}

bool has_code(double I, LightCode code) {
  constexpr double slack = 2e-4;
  const LightCell cell = light_cell(code);
  return cell.low - slack <= I && I <= cell.high + slack;
}

}  // namespace fos
