// The machine's intervals against MPFI's of the same number of bits.
#include "hardware_interval.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "catch2.hpp"
#include "interval.hpp"

using namespace fos::certified;
using fos::reference::Interval;

namespace {

enum Operation { add, subtract, multiply, divide, negate, squared, root, united, operations };

template <class Number>
Number apply(int operation, const Number& a, const Number& b) {
  switch (operation) {
    case add:
      return a + b;
    case subtract:
      return a - b;
    case multiply:
      return a * b;
    case divide:
      return a / b;
    case negate:
      return -a;
    case squared:
      return square(a);
    case root:
      return sqrt(without_negative(a));
    default:
      return hull(a, b);
  }
}

template <class Real>
mpq_class exact(Real x) {
  mpfr_t number;
  mpfr_init2(number, 64);
  mpfr_set_ld(number, static_cast<long double>(x), MPFR_RNDN);
  mpq_class result;
  mpfr_get_q(result.get_mpq_t(), number);
  mpfr_clear(number);
  return result;
}

template <class Real>
Interval to_mpfi(const HardwareInterval<Real>& x) {
  constexpr mpfr_prec_t bits = HardwareInterval<Real>::digits;
  return hull(Interval(bits, exact(x.low())), Interval(bits, exact(x.high())));
}

/// Ends of all kinds: full significands and short ones, of both signs, 0, nearly equal ones.
template <class Real>
class Operands {
 public:
  HardwareInterval<Real> next() {
    const Real x = end();
    const Real y = once_in(4) ? x : once_in(3) ? x + std::abs(x) * Limits::epsilon() : end();
    return HardwareInterval<Real>::between(std::min(x, y), std::max(x, y));
  }

 private:
  using Limits = std::numeric_limits<Real>;

  Real end() {
    if (once_in(8)) return 0;
    constexpr int digits = Limits::digits;
    const int kept = once_in(3) ? 1 + below(6) : digits;
    const std::uint64_t significand = bits() >> (64 - kept);
    const Real x = std::ldexp(static_cast<Real>(significand), below(24) - 12 - kept);
    return once_in(2) ? -x : x;
  }
  int below(int limit) { return static_cast<int>(bits() % static_cast<std::uint64_t>(limit)); }
  bool once_in(int times) { return below(times) == 0; }
  std::uint64_t bits() {  // Steele, Lea, Flood: SplitMix
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_ = 1;
};

/// For each operation, how often the machine's ends were not MPFI's. `upward`: as it must be;
/// otherwise the planted mistake, rounding to nearest.
template <class Real>
std::array<int, operations> differences(bool upward) {
  using Number = HardwareInterval<Real>;
  constexpr int count = 4000;
  Operands<Real> operands;
  std::vector<Number> a;
  std::vector<Number> b;
  for (int i = 0; i < count; ++i) {
    a.push_back(operands.next());
    b.push_back(operands.next());
  }
  std::array<int, operations> different{};
  for (int operation = 0; operation < operations; ++operation) {
    std::vector<Number> results;
    std::vector<bool> in_range;
    {
      const RoundUp rounding;
      if (!upward) std::fesetround(FE_TONEAREST);
      for (std::size_t i = 0; i < a.size(); ++i) {
        RoundUp::start();
        const bool has_root = operation != root || a[i].high_sign() >= 0;
        results.push_back(has_root ? apply(operation, a[i], b[i]) : a[i]);
        in_range.push_back(has_root && RoundUp::is_in_range());
      }
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (operation == root && a[i].high_sign() < 0) continue;
      const Interval expected = apply(operation, to_mpfi(a[i]), to_mpfi(b[i]));
      const bool holds_zero = operation == divide && to_mpfi(b[i]).holds_zero();
      const bool same = in_range[i] && expected.exact_low() == exact(results[i].low()) &&
                        expected.exact_high() == exact(results[i].high());
      // What has no bounded result must say so; all else must be MPFI's.
      const bool right = holds_zero ? !in_range[i] : same;
      different[static_cast<std::size_t>(operation)] += right ? 0 : 1;
    }
  }
  return different;
}

template <class Real>
void check_operations() {
  CHECK(differences<Real>(true) == std::array<int, operations>{});
  const std::array<int, operations> planted = differences<Real>(false);
  for (const int operation : {add, subtract, multiply, divide, squared, root}) {
    INFO("operation " << operation);
    CHECK(planted[static_cast<std::size_t>(operation)] > 100);
  }
}

template <class Real>
void check_range() {
  using Number = HardwareInterval<Real>;
  using Limits = std::numeric_limits<Real>;
  const std::vector<Real> numbers{Limits::max(), Limits::min(), Limits::min() * 3, Real{1} / 4};
  const std::vector<Number> x{Number::exactly(numbers[0]), Number::exactly(numbers[1]),
                              Number::exactly(numbers[2]), Number::exactly(numbers[3])};
  std::vector<Number> results;
  const RoundUp rounding;
  const auto leaves_range = [&](int operation, const Number& a, const Number& b) {
    RoundUp::start();
    results.push_back(apply(operation, a, b));
    return !RoundUp::is_in_range();
  };
  CHECK(leaves_range(add, x[0], x[0]));
  CHECK(leaves_range(subtract, -x[0], x[0]));
  CHECK(leaves_range(squared, x[0], x[0]));
  CHECK(leaves_range(squared, x[1], x[1]));
  CHECK(leaves_range(divide, x[3], x[1] - x[1]));
  CHECK(leaves_range(divide, x[1], x[0]));
  // Below the smallest normal number nothing is lost yet: exact results are MPFI's.
  CHECK_FALSE(leaves_range(multiply, x[1], x[3]));
  CHECK(results.back().low() == results.back().high());
  CHECK_FALSE(leaves_range(multiply, x[2], x[3]));
  CHECK_FALSE(leaves_range(add, x[0], x[1] - x[1]));
}

template <class Real>
void check_numbers() {
  using Number = HardwareInterval<Real>;
  for (const mpq_class& number :
       {mpq_class(0), mpq_class(1, 3), mpq_class(-2, 7), mpq_class(5, 4), mpq_class(-1)}) {
    const RoundUp rounding;
    const Number rounded(Number::digits, number);
    const Interval expected(Number::digits, number);
    CHECK(RoundUp::is_in_range());
    CHECK(exact(rounded.low()) == expected.exact_low());
    CHECK(exact(rounded.high()) == expected.exact_high());
  }
  const mpz_class large = mpz_class(1) << (std::numeric_limits<Real>::max_exponent + 1);
  for (const mpq_class& number : {mpq_class(large), mpq_class(mpz_class(1), large * large)}) {
    const RoundUp rounding;
    const Number lost(Number::digits, number);
    CHECK_FALSE(RoundUp::is_in_range());
  }
}

}  // namespace

TEST_CASE("the machine's intervals have MPFI's ends, and rounding to nearest is found out") {
  check_operations<float>();
  check_operations<double>();
  check_operations<long double>();
}

TEST_CASE("what leaves the range of the machine's numbers is noted") {
  check_range<float>();
  check_range<double>();
  check_range<long double>();
}

TEST_CASE("a scene's number is in the narrowest interval, or out of range") {
  check_numbers<float>();
  check_numbers<double>();
  check_numbers<long double>();
}

TEST_CASE("what an interval of more digits becomes holds it") {
  const mpq_class third(1, 3);
  const RoundUp rounding;
  const HardwareInterval<long double> wide(64, third);
  const auto narrow = HardwareInterval<double>::around(wide);
  CHECK(exact(narrow.low()) <= exact(wide.low()));
  CHECK(exact(narrow.high()) >= exact(wide.high()));
  CHECK(exact(narrow.high()) - exact(narrow.low()) == mpq_class(1, 1L << 54));
}

TEST_CASE("the caller's rounding comes back") {
  { const RoundUp rounding; }
  CHECK(std::fegetround() == FE_TONEAREST);
}
