#include "rounded_scene.hpp"

#include "catch2.hpp"
#include "test_scene.hpp"

using namespace fos::reference;

namespace {

const std::string white = " color = (255, 255, 255) }";

/// What a program of `bits` may see straight ahead.
Possible possible_ahead(const std::string& lines, mpfr_prec_t bits) {
  const ExactScene scene = small_exact_scene(lines);
  return RoundedScene(scene, bits).possible(1, 0);
}

}  // namespace

TEST_CASE("a tangent ray is decided where every way is exact") {
  // CO = (0, -3, -4) and |CO| = 5.
  const Possible touched = possible_ahead("sphere { center = (0, 3, 4) radius = 3" + white, 24);
  CHECK_FALSE(touched.background);
  CHECK(touched.hits.size() == 1);
  // |CO| is not a float, so c from its factors is not exact.
  const Possible open = possible_ahead("sphere { center = (0, 1, 3) radius = 1" + white, 53);
  CHECK(open.background);
  CHECK(open.hits.size() == 1);
}

TEST_CASE("a tie is decided where t is exact: the first in the file") {
  const std::string small = "sphere { center = (0, 0, 4) radius = 1" + white;
  const std::string large = "sphere { center = (0, 0, 5) radius = 2" + white;
  const Possible exact = possible_ahead(small + large, 24);
  REQUIRE(exact.hits.size() == 1);
  CHECK(exact.hits[0].sphere == 0);
  // 0.1 is not a float: either may be seen.
  const Possible rounded = possible_ahead("sphere { center = (0, 0, 3.3) radius = 0.1" + white +
                                              "sphere { center = (0, 0, 3.6) radius = 0.4" + white,
                                          24);
  CHECK(rounded.hits.size() == 2);
  CHECK_FALSE(rounded.background);
}

TEST_CASE("a repeated sphere is never seen") {
  const std::string one = "sphere { center = (0.1, 0.1, 3.7) radius = 1.3" + white;
  const Possible possible = possible_ahead(one + one, 24);
  REQUIRE(possible.hits.size() == 1);
  CHECK(possible.hits[0].sphere == 0);
}

TEST_CASE("near t = 1 both roots may be seen") {
  // 2.1 - 1.1 = 1 in decimals only.
  const Possible possible =
      possible_ahead("sphere { center = (0, 0, 2.1) radius = 1.1" + white, 24);
  REQUIRE(possible.hits.size() == 2);
  CHECK(possible.hits[0].sign == -1);
  CHECK(possible.hits[1].sign == 1);
  CHECK_FALSE(possible.background);
}

TEST_CASE("a light that may be at P or beside it leaves the pixel open") {
  const std::string sphere = "sphere { center = (0, 0, 3.7) radius = 0.6" + white;
  const std::string light = "light { type = point intensity = 1 position = (0, 0, 3.1) }";
  CHECK_FALSE(possible_ahead(sphere + light, 24).judged);
  // Where all is exact it is there, and adds nothing.
  const Possible exact =
      possible_ahead("sphere { center = (0, 0, 4) radius = 1" + white +
                         "light { type = point intensity = 1 position = (0, 0, 3) }",
                     24);
  REQUIRE(exact.judged);
  CHECK(exact.hits[0].terms[0].exact_high() == 0);
}
