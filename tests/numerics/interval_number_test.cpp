// Interval arithmetic in doubles: outward, tight to one step, and useless without the rounding
// mode.
#include "interval_number.hpp"

#include <cstdlib>

#include "catch2.hpp"

using namespace fos::numerics;

namespace {

// Hidden from the compiler, which must not compute the results at its own rounding.
double hidden(double value) {
  volatile double out = value;
  return out;
}

/// The long double result is exact enough to lie strictly between neighbouring doubles.
bool holds(IntervalNumber interval, long double exact) {
  return static_cast<long double>(interval.low()) <= exact &&
         exact <= static_cast<long double>(interval.high());
}

bool is_tight(IntervalNumber interval) {
  const double step =
      std::nextafter(std::abs(interval.high()), INFINITY) - std::abs(interval.high());
  return interval.high() - interval.low() <= 2 * step;
}

}  // namespace

TEST_CASE("every operation holds the exact result and is tight") {
  const RoundUpward upward;
  const double values[] = {1, 3, 0.1, -0.1, -7, 1e-9, 123456.789, -2.5e11};
  for (const double x : values) {
    for (const double y : values) {
      INFO(x << " and " << y);
      const IntervalNumber a = hidden(x);
      const IntervalNumber b = hidden(y);
      const long double p = x;
      const long double q = y;
      CHECK(holds(a + b, p + q));
      CHECK(holds(a - b, p - q));
      CHECK(holds(a * b, p * q));
      CHECK(holds(a / b, p / q));
      CHECK(is_tight(a * b));
      CHECK(is_tight(a / b));
    }
    const IntervalNumber a = hidden(std::abs(x));
    CHECK(holds(sqrt(a), std::sqrt(static_cast<long double>(std::abs(x)))));
    CHECK(is_tight(sqrt(a)));
    CHECK(holds(square(IntervalNumber(hidden(x))), static_cast<long double>(x) * x));
  }
  const IntervalNumber third = IntervalNumber(hidden(1)) / hidden(3);
  CHECK(third.low() < third.high());  // 1/3 is no double
}

TEST_CASE("intervals with ends of either sign") {
  const RoundUpward upward;
  const IntervalNumber across(-2, 3);
  CHECK((across * across).low() == -6);
  CHECK((across * across).high() == 9);
  CHECK(square(across).low() == 0);
  CHECK(square(across).high() == 9);
  CHECK((-across).low() == -3);
  CHECK((across - across).high() == 5);
  CHECK(positive_part(across).low() == 0);
  CHECK(sqrt(across).low() == 0);
  CHECK((IntervalNumber(-4, -2) / IntervalNumber(2, 4)).low() == -2);
  CHECK((IntervalNumber(-4, -2) / IntervalNumber(2, 4)).high() == -0.5);
}

TEST_CASE("what has no bound says so") {
  const RoundUpward upward;
  CHECK_FALSE((IntervalNumber(1) / IntervalNumber(-1, 1)).is_finite());
  CHECK_FALSE((IntervalNumber(0) / IntervalNumber(0)).is_finite());
  CHECK_FALSE((IntervalNumber(0) * IntervalNumber::all()).is_finite());
  CHECK_FALSE((IntervalNumber(hidden(1e200)) * IntervalNumber(hidden(1e200))).is_finite());
}

TEST_CASE("without rounding upward an interval misses the exact result") {
  const IntervalNumber third = IntervalNumber(hidden(1)) / hidden(3);
  CHECK_FALSE(third.low() < third.high());
  {
    const RoundUpward upward;
    CHECK(hidden(1) + hidden(1e-30) > 1);
  }
  CHECK(hidden(1) + hidden(1e-30) == 1);  // the mode is taken back
}
