#include "certified_light.hpp"

#include "catch2.hpp"
#include "rational_term.hpp"
#include "test_scene.hpp"

using namespace fos::reference;

namespace {

const std::string sphere = "sphere { center = (0, 0, 5) radius = 2 color = (255, 255, 255) }";

/// The terms of the lights at the hit straight ahead, P = (0, 0, 3) and N = (0, 0, -1).
std::vector<Enclosure> terms_ahead(const std::string& lights) {
  const ExactScene scene = small_exact_scene(sphere + lights);
  return certified_terms(scene, ahead, exact_hit(scene, ahead).value(), 96).value();
}

}  // namespace

TEST_CASE("rational terms are exact") {
  const auto terms = terms_ahead(
      "light { type = point intensity = 0.3 position = (0, 0, 1) }"             // parallel
      "light { type = point intensity = 0.3 position = (4, 0, 0) }"             // 3/5
      "light { type = point intensity = 0.3 position = (7, 1, 3) }"             // perpendicular
      "light { type = point intensity = 0.3 position = (0, 0, 3) }"             // at P itself
      "light { type = directional intensity = 0.3 direction = (0, 0, -9) }"     // parallel
      "light { type = directional intensity = 0.3 direction = (0, 0.3, 0.4) }"  // from behind
      "light { type = directional intensity = 0.3 direction = (1, -1, 0) }");   // perpendicular
  const std::vector<mpq_class> expected{mpq_class(3, 10), mpq_class(9, 50),  0, 0,
                                        mpq_class(3, 10), mpq_class(-6, 25), 0};
  REQUIRE(terms.size() == expected.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    CAPTURE(i);
    CHECK(terms[i].low == expected[i]);
    CHECK(terms[i].high == expected[i]);
  }
}

TEST_CASE("other terms are enclosed as tightly as the bits allow") {
  // L = (1, 0, -1): cos = 1 / sqrt(2).
  const auto terms = terms_ahead("light { type = point intensity = 1 position = (1, 0, 2) }");
  REQUIRE(terms.size() == 1);
  CHECK(terms[0].low * terms[0].low < mpq_class(1, 2));
  CHECK(terms[0].high * terms[0].high > mpq_class(1, 2));
  CHECK(terms[0].high - terms[0].low < mpq_class(1, mpz_class(1) << 85));
}

TEST_CASE("a perpendicular light is 0 where P is not rational") {
  // In the plane y = 0 a light from above is perpendicular to N everywhere.
  const ExactScene scene = small_exact_scene(
      sphere + "light { type = directional intensity = 1 direction = (0, 3, 0) }");
  const Triple<mpq_class> D{mpq_class(1, 7), 0, 1};
  const ExactHit hit = exact_hit(scene, D).value();
  CHECK(rational_term(scene, D, hit, scene.lights[0]) == mpq_class(0));
}

TEST_CASE("sums leave negative terms out") {
  const ExactScene scene =
      small_exact_scene(sphere +
                        "light { type = point intensity = 0.25 position = (0, 0, 1) }"
                        "light { type = point intensity = 0.5 position = (0, 0, 9) }"
                        "light { type = directional intensity = 0.125 direction = (0, 0, -1) }"
                        "light { type = directional intensity = 0.5 direction = (0, 0, -2) }");
  const auto terms = certified_terms(scene, ahead, exact_hit(scene, ahead).value(), 96).value();
  const TermSums sums = sum_terms(scene, terms);
  CHECK(sums.point.low == mpq_class(1, 4));
  CHECK(sums.point.high == mpq_class(1, 4));
  CHECK(sums.directional.high == mpq_class(5, 8));
}
