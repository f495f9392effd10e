// Each sum keeps its bound on numbers chosen against it, and the slides' loop does not keep those
// of the others.
#include "sums.hpp"

#include <limits>
#include <random>
#include <vector>

#include "catch2.hpp"

using namespace fos::numerics;

namespace {

constexpr double u = std::numeric_limits<float>::epsilon() / 2;

/// A double adds up floats of one size without an error that matters here.
double exact(const std::vector<float>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// What a sum is off by, in units of u Σ|x|, for x > 0.
double error(float (*sum)(std::span<const float>), const std::vector<float>& x) {
  return std::abs(sum(x) - exact(x)) / (u * exact(x));
}

std::vector<float> lights(std::size_t n) {
  std::mt19937 random(2);
  std::vector<float> x(n);
  for (float& each : x) each = static_cast<float>(random()) / static_cast<float>(n);
  return x;
}

}  // namespace

TEST_CASE("a million lights: in pairs within (128 + log2(n/128)) u, compensated within 2 u") {
  const std::vector<float> x = lights(1'000'000);
  CHECK(error(pairwise_sum<float>, x) <= 128 + 13);
  CHECK(error(compensated_sum<float>, x) <= 2);
  CHECK(error(naive_sum<float>, x) > 128 + 13);
}

TEST_CASE("equal lights: the loop stops growing where a light is half a unit in the last place") {
  const std::vector<float> x(1 << 25, 1);
  CHECK(naive_sum<float>(x) == 1 << 24);
  CHECK(pairwise_sum<float>(x) == 1 << 25);
  CHECK(compensated_sum<float>(x) == 1 << 25);
}

TEST_CASE("a weak light among strong ones is not lost when compensated, in any order") {
  for (const std::vector<float>& x :
       {std::vector<float>{1e8F, 1, -1e8F}, std::vector<float>{1, 1e8F, -1e8F}}) {
    CHECK(naive_sum<float>(x) == 0);
    CHECK(compensated_sum<float>(x) == 1);
  }
}

TEST_CASE("nothing adds up to 0") {
  CHECK(naive_sum<float>({}) == 0);
  CHECK(pairwise_sum<float>({}) == 0);
  CHECK(compensated_sum<float>({}) == 0);
}
