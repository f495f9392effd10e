// Three ways to add up numbers: as the slides' loop does, in pairs, and with the rounding errors
// carried along. For n numbers x, to first order in u, the sum is off by at most
//   naive        (n − 1) u Σ|x|
//   pairwise     (128 + log2(n / 128)) u Σ|x|, or log2(n) u Σ|x| without the blocks of 128
//   compensated  u |Σx|, and n² u² Σ|x|
// (Higham, "Accuracy and Stability of Numerical Algorithms", ch. 4).
#pragma once

#include <cmath>
#include <numeric>
#include <span>

namespace fos::numerics {

template <class T>
T naive_sum(std::span<const T> x) {
  return std::accumulate(x.begin(), x.end(), T{0});
}

/// Halves are added up apart; below 128 numbers that is no longer worth a call.
template <class T>
T pairwise_sum(std::span<const T> x) {
  if (x.size() <= 128) return naive_sum(x);
  const std::size_t half = x.size() / 2;
  return pairwise_sum(x.first(half)) + pairwise_sum(x.subspan(half));
}

/// Neumaier's form of Kahan's sum, also where a number is larger than the sum before it.
template <class T>
T compensated_sum(std::span<const T> x) {
  T sum = 0;
  T lost = 0;
  for (const T each : x) {
    const T next = sum + each;
    lost += std::abs(sum) >= std::abs(each) ? (sum - next) + each : (each - next) + sum;
    sum = next;
  }
  return sum + lost;
}

}  // namespace fos::numerics
