#include "fos/closest_hit.hpp"

#include "catch2.hpp"

using namespace fos;

namespace {

Scene scene_of(std::initializer_list<Sphere> spheres) {
  Scene scene;
  scene.spheres = spheres;
  return scene;
}

const Vec3 origin(0);
const Vec3 ahead(0, 0, 1);

}  // namespace

TEST_CASE("nothing to hit") {
  CHECK_FALSE(closest_hit(origin, ahead, 1, infinity, Scene()));
  CHECK_FALSE(closest_hit(origin, ahead, 1, infinity, scene_of({{Vec3(5, 0, 3), 1, Color(0)}})));
  CHECK_FALSE(closest_hit(origin, ahead, 1, infinity, scene_of({{Vec3(0, 0, -3), 1, Color(0)}})));
}

TEST_CASE("the nearer root of the nearest sphere, t in units of D") {
  const Scene scene = scene_of({{Vec3(0, 0, 9), 1, Color(0)}, {Vec3(0, 0, 4), 1, Color(0)}});
  const auto hit = closest_hit(origin, ahead, 1, infinity, scene);
  REQUIRE(hit);
  CHECK(hit->t == 3);
  CHECK(hit->sphere == &scene.spheres[1]);
  CHECK(closest_hit(origin, Vec3(0, 0, 0.5), 1, infinity, scene)->t == 6);
}

TEST_CASE("the interval of t is closed at both ends, and both roots are candidates") {
  const Scene scene = scene_of({{Vec3(0, 0, 4), 1, Color(0)}});  // t = 3 and 5
  CHECK(closest_hit(origin, ahead, 3, infinity, scene)->t == 3);
  CHECK(closest_hit(origin, ahead, Real(3.5), infinity, scene)->t == 5);
  CHECK(closest_hit(origin, ahead, 5, 5, scene)->t == 5);
  CHECK_FALSE(closest_hit(origin, ahead, Real(5.5), infinity, scene));
  CHECK_FALSE(closest_hit(origin, ahead, 1, Real(2.5), scene));
}

TEST_CASE("from inside, from the centre, and from the surface") {
  const Scene scene = scene_of({{Vec3(0, 0, 0), 2, Color(0)}});
  CHECK(closest_hit(origin, ahead, 1, infinity, scene)->t == 2);
  CHECK(closest_hit(Vec3(0, 0, -1), ahead, 1, infinity, scene)->t == 3);
  CHECK(closest_hit(Vec3(0, 0, -2), ahead, 0, infinity, scene)->t == 0);
  CHECK(closest_hit(Vec3(0, 0, -2), ahead, 1, infinity, scene)->t == 4);
  // On the surface, along it: both roots are 0.
  CHECK(closest_hit(Vec3(0, 2, 0), ahead, 0, infinity, scene)->t == 0);
  CHECK_FALSE(closest_hit(Vec3(0, 2, 0), ahead, 1, infinity, scene));
}

TEST_CASE("a tangent ray hits") {
  const auto hit =
      closest_hit(origin, ahead, 1, infinity, scene_of({{Vec3(0, -1, 3), 1, Color(0)}}));
  REQUIRE(hit);
  CHECK(hit->t == 3);
}

TEST_CASE("of two equal hits the first sphere wins") {
  const Scene scene = scene_of({{Vec3(0, 0, 4), 1, Color(1)}, {Vec3(0, 0, 4), 1, Color(2)}});
  CHECK(closest_hit(origin, ahead, 1, infinity, scene)->sphere == &scene.spheres[0]);
}

TEST_CASE("a small sphere far away keeps its shape") {
  // 1000 radii away, off the axis; exact t by hand: rays through the centre, t = (|C| - r) / |D|.
  const Vec3 C(300, 400, 1200);  // |C| = 1300
  const Scene scene = scene_of({{C, Real(1.3L), Color(0)}});
  const auto hit = closest_hit(origin, C / 1300, 1, infinity, scene);
  REQUIRE(hit);
  CHECK(std::abs(hit->t - Real(1298.7L)) < 4000 * std::numeric_limits<Real>::epsilon());
  // Rays that pass the centre at 0.999 and 1.001 radii: b² − 4ac is wrong here in float.
  const Vec3 side = normalize(Vec3(4, -3, 0)) * Real(1.3L);
  CHECK(closest_hit(origin, C + side * Real(0.999L), 0, infinity, scene));
  CHECK_FALSE(closest_hit(origin, C + side * Real(1.001L), 0, infinity, scene));
}
