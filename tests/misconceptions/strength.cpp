#include "strength.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fos/text.hpp"

namespace fos {
namespace {

constexpr std::size_t fewest = 20;

/// What all the ranges have in common; nothing where that is nothing.
std::optional<Range> common(const std::vector<Range>& ranges) {
  Range all = ranges.front();
  for (const Range& range : ranges) {
    all = {std::max(all.low, range.low), std::min(all.high, range.high)};
  }
  if (all.low > all.high) return std::nullopt;
  return all;
}

/// Whether the ratios of each group may be one number; a group is what `key` gives.
template <typename Key>
bool constant_in_each(const std::vector<Lit>& pixels, const Key& key) {
  std::map<std::size_t, std::vector<Range>> groups;
  for (const Lit& pixel : pixels) groups[key(pixel)].push_back(pixel.ratio);
  return std::all_of(groups.begin(), groups.end(),
                     [](const auto& group) { return common(group.second).has_value(); });
}

/// How much of the ratios' variance is left when each is compared with its neighbours by `key`: 0
/// for a function of it, about 1 or more where it has nothing to do with it.
template <typename Key>
double left_over(std::vector<Lit> pixels, const Key& key) {
  std::sort(pixels.begin(), pixels.end(),
            [&](const Lit& a, const Lit& b) { return key(a) < key(b); });
  double mean = 0;
  for (const Lit& pixel : pixels) {
    mean += pixel.ratio.middle() / static_cast<double>(pixels.size());
  }
  double variance = 0;
  double left = 0;
  for (std::size_t i = 1; i + 1 < pixels.size(); ++i) {
    const double ratio = pixels[i].ratio.middle();
    const double between = (pixels[i - 1].ratio.middle() + pixels[i + 1].ratio.middle()) / 2;
    left += (ratio - between) * (ratio - between);
    variance += (ratio - mean) * (ratio - mean);
  }
  return variance == 0 ? 0 : left / variance;
}

/// The power of |L| that the ratio may be, times a constant.
std::optional<int> power_of_distance(const std::vector<Lit>& pixels) {
  for (const int power : {-3, -2, -1, 1, 2, 3}) {
    std::vector<Range> scaled;
    for (const Lit& pixel : pixels) {
      const double by_low = std::pow(pixel.distance.low, -power);
      const double by_high = std::pow(pixel.distance.high, -power);
      scaled.push_back({pixel.ratio.low * std::min(by_low, by_high),
                        pixel.ratio.high * std::max(by_low, by_high)});
    }
    if (common(scaled)) return power;
  }
  return std::nullopt;
}

}  // namespace

Strength strength_of(const std::vector<Lit>& pixels) {
  if (pixels.size() < fewest) return {Dependence::unknown, 1, {}};
  std::vector<Range> ratios;
  ratios.reserve(pixels.size());
  for (const Lit& pixel : pixels) ratios.push_back(pixel.ratio);
  if (const auto factor = common(ratios)) {
    const bool is_1 = factor->low <= 1 && 1 <= factor->high;
    return {is_1 ? Dependence::none : Dependence::constant, factor->middle(), {}};
  }
  if (constant_in_each(pixels, [](const Lit& pixel) { return pixel.light; })) {
    return {Dependence::light, 1, {}};
  }
  if (constant_in_each(pixels, [](const Lit& pixel) { return pixel.sphere; })) {
    return {Dependence::sphere, 1, {}};
  }
  const bool has_distance = pixels.front().distance.low > 0;
  if (has_distance) {
    if (const auto power = power_of_distance(pixels)) return {Dependence::distance, 1, power};
  }
  // What is left over by one of the two must be little, and much less than by the other. Where the
  // right term is small, its cell is too coarse for that.
  constexpr double little = 0.02;
  std::vector<Lit> fine = pixels;
  std::erase_if(fine, [](const Lit& pixel) {
    return pixel.ratio.high - pixel.ratio.low > 0.02 * pixel.ratio.high;
  });
  if (fine.size() < fewest) return {Dependence::unknown, 1, {}};
  const double by_angle = left_over(fine, [](const Lit& pixel) { return pixel.cosine; });
  const double by_distance =
      has_distance ? left_over(fine, [](const Lit& pixel) { return pixel.distance.low; }) : 1;
  if (by_angle < little && by_angle < by_distance / 4) return {Dependence::angle, 1, {}};
  if (by_distance < little && by_distance < by_angle / 4) return {Dependence::distance, 1, {}};
  return {Dependence::unknown, 1, {}};
}

std::string describe(const Strength& strength) {
  switch (strength.on) {
    case Dependence::constant:
      return say(text::locate_constant, {fmt::format("{:.3g}", strength.factor)});
    case Dependence::light:
      return say(text::locate_by_light);
    case Dependence::sphere:
      return say(text::locate_by_sphere);
    case Dependence::distance:
      return strength.power ? say(text::locate_by_power, {fmt::format("|L|^{}", *strength.power)})
                            : say(text::locate_by_distance);
    case Dependence::angle:
      return say(text::locate_by_angle);
    default:
      return say(text::locate_by_unknown);
  }
}

}  // namespace fos
