#include "exact_scene.hpp"

#include "catch2.hpp"
#include "exact_hit.hpp"
#include "test_scene.hpp"

using namespace fos;
using namespace fos::reference;

TEST_CASE("decimals become exact numbers") {
  CHECK(to_exact(parse_decimal("0")) == 0);
  CHECK(to_exact(parse_decimal("0.1")) == mpq_class(1, 10));
  CHECK(to_exact(parse_decimal("-12.50")) == mpq_class(-25, 2));
  CHECK(to_exact(parse_decimal("4e3")) == 4000);
  CHECK(to_exact(parse_decimal("1e-3")) == mpq_class(1, 1000));
  CHECK_THROWS_AS(to_exact(parse_decimal("1e999999")), std::range_error);
}

TEST_CASE("canvas coordinates are in lowest terms") {
  const ExactScene scene = to_exact(parse_scene_text("canvas_size = 600 x 4", "test"));
  CHECK(scene.canvas_x(250) == -50);
  CHECK(scene.canvas_y(3) == -2);
}

TEST_CASE("the middle of an odd canvas is half a pixel off a ray") {
  const ExactScene scene = to_exact(parse_scene_text("canvas_size = 5 x 3", "test"));
  CHECK(scene.canvas_x(0) == mpq_class(-5, 2));
  CHECK(scene.canvas_x(4) == mpq_class(3, 2));
  CHECK(scene.canvas_y(0) == mpq_class(1, 2));
  CHECK(scene.canvas_y(2) == mpq_class(-3, 2));
}

TEST_CASE("D goes through the viewport") {
  const ExactScene scene = to_exact(parse_scene_text(
      "canvas_size = 4 x 2\nviewport_size = 3 x 0.5\nprojection_plane_d = 1.25", "test"));
  CHECK(exact_direction(scene, 0, 0) == Triple<mpq_class>{mpq_class(-3, 2), 0, mpq_class(5, 4)});
  CHECK(exact_direction(scene, 3, 1) ==
        Triple<mpq_class>{mpq_class(3, 4), mpq_class(-1, 4), mpq_class(5, 4)});
}

TEST_CASE("lights keep their order; a scene without ambient light has I_A = 0") {
  const ExactScene scene = small_exact_scene(
      "light { type = directional intensity = 2 direction = (1, 0, 0) }"
      "light { type = point intensity = 3 position = (0, 1, 0) }");
  REQUIRE(scene.lights.size() == 2);
  CHECK_FALSE(scene.lights[0].is_point);
  CHECK(scene.lights[1].is_point);
  CHECK(scene.ambient == 0);
}
