#include "catch2.hpp"
#include "fos/scene_text.hpp"

using namespace fos;

TEST_CASE("a decimal keeps exactly what is written") {
  const Decimal value = parse_decimal("-0120.3400e-2");
  CHECK(value.negative);
  CHECK(value.digits == "12034");
  CHECK(value.exponent == -4);
  CHECK(value.text == "-0120.3400e-2");
}

TEST_CASE("every form of a number is read") {
  for (const char* text : {"5", "+5", "5.", "5.0", "0.5e1", ".5E+1", "50e-1", "0005"}) {
    INFO(text);
    CHECK(compare(parse_decimal(text), parse_decimal("5")) == 0);
  }
  for (const char* text : {"0", "-0", "0.000", "0e9", ".0"}) {
    INFO(text);
    CHECK(parse_decimal(text).is_zero());
    CHECK_FALSE(parse_decimal(text).negative);
  }
}

TEST_CASE("what is no number is refused") {
  for (const char* text :
       {"", ".", "-", "1.2.3", "1e", "1e+", "e5", "0x10", "1 ", "inf", "nan", "1,5", "--1"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_decimal(text), std::invalid_argument);
  }
}

TEST_CASE("decimals are compared exactly") {
  const auto order = [](const char* a, const char* b) {
    const int there = compare(parse_decimal(a), parse_decimal(b));
    CHECK(compare(parse_decimal(b), parse_decimal(a)) == -there);
    return there;
  };
  CHECK(order("1", "2") == -1);
  CHECK(order("-1", "-2") == 1);
  CHECK(order("-1", "0") == -1);
  CHECK(order("9", "10") == -1);
  CHECK(order("0.1", "0.10000000000000000000000000000000001") == -1);
  CHECK(order("1e-400", "0") == 1);
  CHECK(order("123e2", "12300") == 0);
  CHECK(order("255", "255.0000000000000000000001") == -1);
}

TEST_CASE("an exponent beyond all bounds is cut off, not wrapped around") {
  CHECK(compare(parse_decimal("1.23e-9223372036854775807"), parse_decimal("1e-5000")) == -1);
  CHECK(compare(parse_decimal("100e9223372036854775807"), parse_decimal("1e5000")) == 1);
  CHECK(compare(parse_decimal("1e99999999999999999999"), parse_decimal("1e5000")) == 1);
}
