// The sum over very many lights, made in memory: no scene file holds as many.
#include <gmpxx.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "extremes_families.hpp"
#include "sums.hpp"

namespace fos::numerics {
namespace {

template <class T>
mpf_class exact_sum(std::span<const T> x) {
  mpf_class sum(0, 256);
  for (const T each : x) {
    const auto high = static_cast<double>(each);
    sum += high;
    sum += static_cast<double>(each - static_cast<T>(high));
  }
  return sum;
}

/// The best of several runs, a term; what is added up is not known before each.
template <class T, class Sum>
Answered measured(std::vector<T>& terms, const mpf_class& exact, Sum sum) {
  Answered answered;
  const auto terms_now = static_cast<double>(terms.size());
  answered.ns = 1e9;
  T result = 0;
  const auto runs = std::clamp<std::size_t>(100000 / terms.size(), 3, 10000);
  for (std::size_t run = 0; run < runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    asm volatile("" : : "r"(terms.data()) : "memory");
    result = sum(std::span<const T>(terms));
    asm volatile("" : : "m"(result) : "memory");
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    answered.ns = std::min(answered.ns, time.count() / terms_now);
  }
  const mpf_class error = exact_sum(std::span<const T>(&result, 1)) - exact;
  answered.errors.pixels = 1;
  answered.errors.max = answered.errors.mean = std::abs(error.get_d());
  return answered;
}

/// Terms between 0 and 1/n: I is about 1/2.
template <class T>
Line line_of(std::size_t n, Precision precision) {
  std::mt19937 random(static_cast<unsigned>(n));
  std::vector<T> terms(n);
  for (T& term : terms) {
    term = static_cast<T>(random()) / static_cast<T>(std::mt19937::max()) / static_cast<T>(n);
  }
  const mpf_class exact = exact_sum(std::span<const T>(terms));
  return {std::to_string(n),
          precision,
          {measured(terms, exact, naive_sum<T>), measured(terms, exact, pairwise_sum<T>),
           measured(terms, exact, compensated_sum<T>)}};
}

}  // namespace

Family sums() {
  Family family{"sums",
                text::extremes_sums,
                text::extremes_sums_finding,
                {"naive", "pairwise", "compensated"},
                {},
                {}};
  constexpr std::size_t largest = 10'000'000;
  for (std::size_t n = 1; n <= largest; n *= 10) family.parameters.push_back(std::to_string(n));
  family.ask = [](std::size_t i) {
    const auto n = static_cast<std::size_t>(std::llround(std::pow(10, i)));
    std::vector<Line> lines{line_of<float>(n, Precision::binary32)};
    // The others need many more before anything shows.
    if (n < largest) {
      lines.push_back(line_of<double>(n, Precision::binary64));
      lines.push_back(line_of<long double>(n, Precision::extended));
    }
    return lines;
  };
  return family;
}

}  // namespace fos::numerics
