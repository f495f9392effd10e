#include "number_text.hpp"

#include <cmath>
#include <limits>

#include "catch2.hpp"
#include "surd.hpp"

using namespace fos;
using fos::reference::Enclosure;

namespace {

/// In lowest terms, as GMP's arithmetic needs it.
mpq_class fraction(const char* text) {
  mpq_class x(text);
  x.canonicalize();
  return x;
}

std::string exact(const char* text) {
  const mpq_class x = fraction(text);
  return decimal_text(Enclosure{x, x});
}

}  // namespace

TEST_CASE("exact numbers end where they end, others have 7 digits") {
  CHECK(exact("0") == "0");
  CHECK(exact("12/5") == "2.4");
  CHECK(exact("-50") == "-50");
  CHECK(exact("-1/12") == "-0.08333333");
  CHECK(exact("1/3") == "0.3333333");
  CHECK(exact("9999999") == "9999999");
  CHECK(exact("99999999/10") == "1.000000e7");  // rounded, and says so
  CHECK(exact("10000000") == "1e7");
  CHECK(exact("-1/100000") == "-1e-5");
  CHECK(exact("1/10000") == "0.0001");
  CHECK(exact("2/3000000") == "6.666667e-7");
  CHECK(exact("1230000") == "1230000");
  CHECK(exact("100000000000000000000") == "1e20");
}

TEST_CASE("half goes to even, as the exact number has it") {
  CHECK(decimal_text(mpq_class(25, 10), 1) == "2");
  CHECK(decimal_text(mpq_class(35, 10), 1) == "4");
  CHECK(decimal_text(mpq_class(2500001, 1000000), 1) == "3");
  CHECK(decimal_text(mpq_class(-99, 10), 1) == "-10");
}

TEST_CASE("an enclosure gives the digits that it decides and no others") {
  const auto between = [](const char* low, const char* high) {
    return decimal_text(Enclosure{fraction(low), fraction(high)});
  };
  CHECK(between("23999999999/10000000000", "24000000001/10000000000") == "2.400000");
  CHECK(between("12344/10000", "12346/10000") == "1.23");
  CHECK(between("-12346/10000", "-12344/10000") == "-1.23");
  CHECK(between("-1/1000", "1/500") == "[-0.001, 0.002]");
}

TEST_CASE("a program's numbers") {
  CHECK(decimal_text(0.31L) == "0.31");
  CHECK(decimal_text(static_cast<long double>(0.1 + 0.2)) == "0.3");
  CHECK(decimal_text(static_cast<long double>(0.1 + 0.2), 17) == "0.30000000000000004");
  CHECK(decimal_text(std::numeric_limits<long double>::quiet_NaN()) == "NaN");
  CHECK(decimal_text(-std::numeric_limits<long double>::infinity()) == "-inf");
}

TEST_CASE("numbers with a root in them are exact where they can be") {
  const SurdField two(2);  // 3 - 2 √2 = 0.1715728752538099…
  const Surd x = two.number(3, -2);
  CHECK(two.sign(x) == 1);
  CHECK(decimal_text(two.enclose(x), 15) == "0.171572875253810");
  const Surd y = two.product(x, two.number(3, 2));  // 9 - 8
  CHECK(decimal_text(two.enclose(y)) == "1");
  CHECK(two.sign(y - Surd{1, 0}) == 0);
  const SurdField nine_quarters(mpq_class(9, 4));
  CHECK(decimal_text(nine_quarters.enclose(nine_quarters.number(1, -1))) == "-0.5");
  // 99 - 70 √2 = 0.0050506…: two digits are lost, and all that are shown are right all the
  // same.
  CHECK(decimal_text(two.enclose(two.number(99, -70))) == "0.005050634");
  // (3 - 2 √2)^128: a and b have 98 digits before the point, and the difference 98 zeros after it.
  Surd power = x;
  for (int i = 0; i < 7; ++i) power = two.product(power, power);
  CHECK(decimal_text(two.enclose(power)) == "1.021938e-98");
}

TEST_CASE("roots, quotients and angles of enclosures") {
  CHECK(decimal_text(square_root({mpq_class(49, 4), mpq_class(49, 4)})) == "3.5");
  CHECK(decimal_text(square_root({2, 2}), 12) == "1.41421356237");
  const Enclosure q = quotient({-3, 2}, {2, 4});
  CHECK(q.low == mpq_class(-3, 2));
  CHECK(q.high == 1);
  CHECK(decimal_text(degrees({mpq_class(1, 2), mpq_class(1, 2)})) == "60.00000");
  CHECK(decimal_text(degrees({1, 1})) == "0");
  const Enclosure all = degrees({-2, 2});  // rounding may lead beyond
  CHECK(all.low == 0);
  CHECK(all.high >= 180);
  CHECK(all.high < 181);
}
