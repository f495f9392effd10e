// What is said of the sun: the bound of the directional light that stands for a point light, from
// where on no byte can tell, and where L no longer depends on P.
#include <algorithm>

#include "catch2.hpp"
#include "extremes_families.hpp"
#include "light_going_away.hpp"
#include "scene_parts.hpp"

using namespace fos;
using namespace fos::numerics;

namespace {

/// Every point that the lecture's picture shows, at its own size of 600 x 600.
template <class T>
std::vector<SeenPoint<T>> seen_points() {
  const SceneOf<T> scene = rounded<T>(
      parse_scene_text(canvas(600, 600) + lecture_spheres() + point("0.6", "1, 4, 4"), "lecture"));
  std::vector<SeenPoint<T>> points;
  for (int row = 0; row < scene.height; ++row) {
    for (int column = 0; column < scene.width; ++column) {
      const SeenPoint<T> seen = view(scene, column, row);
      if (seen.sphere >= 0) points.push_back(seen);
    }
  }
  return points;
}

template <class T>
Vec<T> light_at(T distance) {
  return Vec<T>(1, 4, 4) * (distance / std::sqrt(T{33}));
}

}  // namespace

TEST_CASE("a directional light for a far point light: within the bound, within half a byte") {
  const std::vector<SeenPoint<double>> points = seen_points<double>();
  double R = 0;
  for (const auto& seen : points) R = std::max(R, length(seen.P));
  const double I = 0.6;
  const auto difference = [&](double d) {
    const Vec<double> S = light_at(d);
    double largest = 0;
    for (const auto& seen : points) {
      largest = std::max(largest, I * std::abs(cosine(seen, S - seen.P) - cosine(seen, S)));
    }
    return largest;
  };
  for (const double d : {1e2, 1e3, 1e4, 1e6, 1e9}) {
    const double bound = I * 2 * std::sin(std::asin(R / d) / 2);
    CHECK(difference(d) <= bound);
    CHECK(difference(d) > 0.3 * bound);
  }
  CHECK(difference(11170) > half_a_byte);
  CHECK(difference(11180) < half_a_byte);
}

TEST_CASE("beyond |P| 2^24 a point light in float is a directional light, bit for bit") {
  const Vec<float> S = light_at(1.496e11F);
  for (const auto& seen : seen_points<float>()) {
    if (S - seen.P != S) FAIL("L depends on P");
  }
  // In double it is not, by 7e-11 of I; the sun would have to be 10,000 times as far.
  const Vec<double> sun = light_at(1.496e11);
  const auto points = seen_points<double>();
  CHECK(std::any_of(points.begin(), points.end(),
                    [&](const auto& seen) { return sun - seen.P != sun; }));
}

TEST_CASE(
    "the usual shadow ray loses every shadow as the light goes away; in units of the scene, "
    "none") {
  const Family family = shadows();
  const auto at = [&](const char* power) {
    const auto i = std::find(family.parameters.begin(), family.parameters.end(), power);
    return family.ask(static_cast<std::size_t>(i - family.parameters.begin()));
  };
  for (const Line& line : at("1e1")) CHECK_FALSE(line.ways[0].errors.breaks());
  for (const Line& line : at("1e4")) {
    CHECK(line.ways[0].errors.breaks());
    CHECK_FALSE(line.ways[1].errors.breaks());
  }
  // From the light's side it is the precision that counts.
  const std::vector<Line> far = at("1e8");
  CHECK(far[0].ways[2].errors.breaks());
  CHECK_FALSE(far[1].ways[2].errors.breaks());
}
