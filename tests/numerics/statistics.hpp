// What is made of many measurements.
#pragma once

#include <vector>

namespace fos::numerics {

/// The value that `share` (0..1) of the values do not exceed, between two values by their straight
/// line. `values` is not empty and has no NaN; its order is of no account.
double percentile(std::vector<double> values, double share);

inline double median(std::vector<double> values) { return percentile(std::move(values), 0.5); }

/// A measured time: half of the measurements lie between the quartiles.
struct Spread {
  double first_quartile = 0;
  double median = 0;
  double third_quartile = 0;
};
Spread spread_of(const std::vector<double>& values);

/// How many times `base` the times are: the median over the rounds of the ratio inside each round.
/// A machine's clock wanders, and inside a round it wanders least.
double paired_ratio(const std::vector<double>& times, const std::vector<double>& base);

}  // namespace fos::numerics
