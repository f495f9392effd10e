#include "stage_terms.hpp"

#include "catch2.hpp"

using namespace fos::reference;

TEST_CASE("a channel is clamped, then rounded half to even") {
  CHECK(to_byte(-1) == 0);
  CHECK(to_byte(0) == 0);
  CHECK(to_byte(mpq_class(1, 2)) == 0);
  CHECK(to_byte(mpq_class(50000001, 100000000)) == 1);
  CHECK(to_byte(mpq_class(3, 2)) == 2);
  CHECK(to_byte(mpq_class(5, 2)) == 2);
  CHECK(to_byte(mpq_class(253, 2)) == 126);
  CHECK(to_byte(mpq_class(255, 2)) == 128);
  CHECK(to_byte(mpq_class(509, 2)) == 254);
  CHECK(to_byte(mpq_class(254999, 1000)) == 255);
  CHECK(to_byte(255) == 255);
  CHECK(to_byte(1000) == 255);
}

TEST_CASE("a stage's I is a sum of terms") {
  const mpq_class I_A(1, 5);
  CHECK(intensity(flat, I_A, 2, 3) == 1);
  CHECK(intensity(ambient, I_A, 2, 3) == I_A);
  CHECK(intensity(ambient | point, I_A, 2, 3) == I_A + 2);
  CHECK(intensity(ambient | point | directional, I_A, 2, 3) == I_A + 5);
}
