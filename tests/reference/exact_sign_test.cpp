#include "exact_sign.hpp"

#include "catch2.hpp"

using fos::reference::Root;
using fos::reference::sign_of_sum;

TEST_CASE("sign of p + sqrt(x)") {
  CHECK(sign_of_sum(0, Root{1, 0}) == 0);
  CHECK(sign_of_sum(0, Root{-1, 2}) == -1);
  CHECK(sign_of_sum(3, Root{-1, 0}) == 1);
  CHECK(sign_of_sum(3, Root{1, 5}) == 1);
  CHECK(sign_of_sum(-3, Root{1, 9}) == 0);
  CHECK(sign_of_sum(mpq_class(2, 3), Root{-1, mpq_class(4, 9)}) == 0);
  // 577/408 is above the root of 2 by 2e-6, and 1393/985 below it by 4e-7.
  CHECK(sign_of_sum(mpq_class(577, 408), Root{-1, 2}) == 1);
  CHECK(sign_of_sum(mpq_class(1393, 985), Root{-1, 2}) == -1);
}

TEST_CASE("sign of p + sqrt(x) + sqrt(y)") {
  CHECK(sign_of_sum(0, Root{1, 8}, Root{-1, 8}) == 0);
  CHECK(sign_of_sum(0, Root{1, 8}, Root{-1, 9}) == -1);
  CHECK(sign_of_sum(0, Root{-1, 8}, Root{1, 9}) == 1);
  CHECK(sign_of_sum(-5, Root{1, 4}, Root{1, 9}) == 0);
  CHECK(sign_of_sum(1, Root{1, 4}, Root{-1, 9}) == 0);
  CHECK(sign_of_sum(-1, Root{-1, 4}, Root{1, 9}) == 0);
  CHECK(sign_of_sum(7, Root{1, 0}, Root{-1, 0}) == 1);
  CHECK(sign_of_sum(-7, Root{1, 0}, Root{1, 50}) == 1);
  CHECK(sign_of_sum(2, Root{-1, 1}, Root{-1, 2}) == -1);
}

TEST_CASE("sums that a double takes for 0") {
  // The roots of 2 and of 3 add up to 3.14626436994197234232913506571557...
  const mpq_class above("31462643699419723424/10000000000000000000");
  const mpq_class below("31462643699419723423/10000000000000000000");
  CHECK(sign_of_sum(above, Root{-1, 2}, Root{-1, 3}) == 1);
  CHECK(sign_of_sum(below, Root{-1, 2}, Root{-1, 3}) == -1);
  CHECK(sign_of_sum(mpq_class(-above), Root{1, 2}, Root{1, 3}) == -1);
}
