// Running error bounds against exact arithmetic.
#include "bounded.hpp"

#include <gmpxx.h>

#include <cstdint>

#include "catch2.hpp"

using namespace fos::certified;

namespace {

/// A bounded number and the exact one that it stands for.
struct Pair {
  Bounded bounded;
  mpq_class exact;

  bool holds() const {
    return mpq_class(bounded.low()) <= exact && exact <= mpq_class(bounded.high());
  }
};

class Numbers {
 public:
  /// k/7 · 2^e, which no double is.
  Pair next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const long k = static_cast<long>(state_ >> 40) - (1L << 23);
    const int e = static_cast<int>(state_ >> 32 & 31) - 40;
    mpq_class exact(k, 7);
    exact /= mpz_class(1) << static_cast<unsigned>(-e);
    exact.canonicalize();
    return {Bounded::rounded(exact.get_d()), exact};
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace

TEST_CASE("what is computed stays within its bound, and the bound stays small") {
  Numbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const Pair a = numbers.next();
    const Pair b = numbers.next();
    const Pair c = numbers.next();
    REQUIRE(a.holds());
    const Pair sum{a.bounded + b.bounded, a.exact + b.exact};
    const Pair difference{sum.bounded - b.bounded, a.exact};  // cancels
    const Pair product{sum.bounded * c.bounded, sum.exact * c.exact};
    REQUIRE(sum.holds());
    REQUIRE(difference.holds());
    REQUIRE(product.holds());
    if (c.exact != 0) {
      const Pair quotient{product.bounded / c.bounded, sum.exact};
      REQUIRE(quotient.holds());
    }
    const Bounded squared = product.bounded * product.bounded;
    const Pair root{sqrt(squared), abs(product.exact)};
    REQUIRE(root.holds());
    if (product.exact != 0 && abs(sum.exact) > abs(a.exact) / 1000) {
      const double width = root.bounded.high() - root.bounded.low();
      REQUIRE(width <= 1e-11 * root.bounded.high());
    }
  }
}

TEST_CASE("nothing is certain of what is not finite") {
  const Bounded one = Bounded::exactly(1);
  const Bounded may_be_0(1e-20, 1e-19);
  const Bounded unbounded = one / may_be_0;
  CHECK_FALSE(is_less(unbounded, one));
  CHECK_FALSE(is_less(one, unbounded));
  const Bounded as_unbounded = unbounded;
  const Bounded not_a_number = unbounded - as_unbounded;
  CHECK_FALSE(is_less(not_a_number, one));
  CHECK_FALSE(is_less(one, not_a_number));
  CHECK_FALSE(is_less(one, one));
  CHECK(is_less(one, Bounded::exactly(1 + 0x1p-40)));
}

TEST_CASE("the root of what may be negative is enclosed") {
  const Bounded root = sqrt(Bounded(-1e-20, 4e-20));  // at most √3e-20
  CHECK(root.low() <= 0);
  CHECK(root.high() >= 1.7e-10);
  CHECK(root.high() < 3e-10);
}
