#include <sstream>

#include "catch2.hpp"
#include "fos/stage.hpp"

// A student's own helper, outside our namespace.
inline fos::Vec3 doubled(const fos::Vec3& v) { return 2 * v; }

using namespace fos;

TEST_CASE("a vector takes numbers of any type") {
  const Vec3 D(1, 2, 4);
  CHECK(2 * D == Vec3(2, 4, 8));
  CHECK(D * 2 == Vec3(2, 4, 8));
  CHECK(D / 2 == Vec3(0.5, 1, 2));
  CHECK(0.5F * D == Vec3(0.5, 1, 2));
  CHECK(0.5 * D == Vec3(0.5, 1, 2));
  CHECK(0.5L * D == Vec3(0.5, 1, 2));
  CHECK(D * 0.5F == Vec3(0.5, 1, 2));
  CHECK(D / 4L == Vec3(0.25, 0.5, 1));
  CHECK(D * Real(2) == doubled(D));
  CHECK(D * D == Vec3(1, 4, 16));
  CHECK(D + D - 2 * D == Vec3(0));
}

TEST_CASE("dot, length and normalize are GLM's") {
  CHECK(dot(Vec3(1, 2, 3), Vec3(4, 5, 6)) == 32);
  CHECK(length(Vec3(2, 3, 6)) == 7);
  CHECK(normalize(Vec3(0, 0, 5)) == Vec3(0, 0, 1));
}

TEST_CASE("a vector can be printed") {
  std::ostringstream out;
  out << Vec3(1, -2, 0.5) << '!';
  CHECK(out.str() == "(1, -2, 0.5)!");
}
