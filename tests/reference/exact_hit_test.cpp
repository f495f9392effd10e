#include "exact_hit.hpp"

#include "catch2.hpp"
#include "test_scene.hpp"

using namespace fos::reference;

namespace {

const std::string white = " color = (255, 255, 255) }";

/// The sphere that the ray ahead meets, from 0; -1 for none.
int sphere_ahead(const std::string& lines) {
  const auto hit = exact_hit(small_exact_scene(lines), ahead);
  return hit ? hit->sphere : -1;
}

}  // namespace

TEST_CASE("a tangent ray hits, one that passes by a hair does not") {
  CHECK(sphere_ahead("sphere { center = (0, 1, 3) radius = 1" + white) == 0);
  CHECK(sphere_ahead("sphere { center = (0, 1.0000000000000000000001, 3) radius = 1" + white) ==
        -1);
  CHECK(sphere_ahead("sphere { center = (0.1, 0.7, 3) radius = 0.70710678118654752440" + white) ==
        -1);
}

TEST_CASE("of two spheres met at the same t the first in the file is seen") {
  const std::string small = "sphere { center = (0, 0, 4) radius = 1" + white;
  const std::string large = "sphere { center = (0, 0, 5) radius = 2" + white;
  CHECK(sphere_ahead(small + large) == 0);
  CHECK(sphere_ahead(large + small) == 0);
  // And by a hair it is the nearer one.
  CHECK(sphere_ahead("sphere { center = (0, 0, 4.00000000000000000000000001) radius = 1" + white +
                     large) == 1);
}

TEST_CASE("two different irrational roots can be equal") {
  // Both spheres go through the point (0, 0, 3), but their centers are off the ray.
  const std::string one = "sphere { center = (1, 0, 4) radius = 1.4142135623730951" + white;
  const std::string other = "sphere { center = (-1, 0, 4) radius = 1.4142135623730951" + white;
  CHECK(sphere_ahead(one + other) == 0);
  CHECK(sphere_ahead(other + one) == 0);
}

TEST_CASE("t begins at 1, and 1 belongs to it") {
  const auto hit = [](const std::string& center) {
    return exact_hit(small_exact_scene("sphere { center = " + center + " radius = 1" + white),
                     ahead);
  };
  REQUIRE(hit("(0, 0, 2)"));
  CHECK(hit("(0, 0, 2)")->root.sign == -1);
  REQUIRE(hit("(0, 0, 1.99999999999999999999)"));
  CHECK(hit("(0, 0, 1.99999999999999999999)")->root.sign == 1);
  REQUIRE(hit("(0, 0, 0)"));
  CHECK(hit("(0, 0, 0)")->root.sign == 1);
  CHECK(is_at(hit("(0, 0, 0)")->root, 1));
  CHECK_FALSE(hit("(0, 0, -0.00000000000000000001)"));
  CHECK_FALSE(hit("(0, 0, -5)"));
}

TEST_CASE("five rays touch the red sphere of the lecture's scene exactly") {
  const ExactScene scene =
      to_exact(fos::parse_scene_text("sphere { center = (0, -1, 3) radius = 1" + white, "red"));
  const auto touches = [&](int x, int y) {
    const auto hit = exact_hit(scene, exact_direction(scene, 300 + x, 299 - y));
    return hit && hit->root.discriminant == 0;
  };
  CHECK(touches(0, 0));
  CHECK(touches(200, -150));
  CHECK(touches(-200, -150));
  CHECK(touches(200, -300));
  CHECK(touches(-200, -300));
  CHECK_FALSE(exact_hit(scene, exact_direction(scene, 501, 449)));
}
