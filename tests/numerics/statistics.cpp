#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fos::numerics {

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const double below = std::floor(place);
  const auto i = static_cast<std::size_t>(below);
  const double part = place - below;
  if (part == 0) return values[i];  // also where the next is infinite
  return values[i] + part * (values[i + 1] - values[i]);
}

Spread spread_of(const std::vector<double>& values) {
  return {percentile(values, 0.25), percentile(values, 0.5), percentile(values, 0.75)};
}

double paired_ratio(const std::vector<double>& times, const std::vector<double>& base) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < times.size(); ++round) {
    ratios.push_back(times[round] / base[round]);
  }
  return median(ratios);
}

}  // namespace fos::numerics
