#include "chain.hpp"

#include "catch2.hpp"
#include "exact_pixel.hpp"
#include "fos/stage_list.hpp"
#include "number_text.hpp"
#include "test_scenes.hpp"

using namespace fos;
using fos::reference::Enclosure;

namespace {

constexpr unsigned all_terms = ambient_term | point_term | directional_term;

template <class Triple>
std::string text_of(const Triple& triple) {
  return triple_text(triple);
}

bool meet(const Enclosure& x, const Enclosure& y) { return x.low <= y.high && y.low <= x.high; }

/// Whether it is known to nine digits at least.
bool is_narrow(const Enclosure& x) {
  const mpq_class size = std::max(mpq_class(abs(x.low)), mpq_class(abs(x.high)));
  return x.low <= x.high && (x.high - x.low) * 1000000000 <= size;
}

Enclosure squared(const Enclosure& x) {
  const mpq_class low = x.low * x.low;
  const mpq_class high = x.high * x.high;
  return {std::min(low, high), std::max(low, high)};  // an end is 0 or none is
}

}  // namespace

TEST_CASE("the lecture's pixel (300, 349), by hand") {
  // x = 0, y = -50: t = 12/5, P = (0, -1/5, 12/5), N = (0, 4/5, -3/5), L = (2, 6/5, -12/5).
  const Chain chain = certified_chain(lecture_scene(), all_terms, 300, 349);
  CHECK(chain.x == 0);
  CHECK(chain.y == -50);
  CHECK(chain.D[1] == mpq_class(-1, 12));
  REQUIRE(chain.hit.has_value());
  const Hit& hit = *chain.hit;
  CHECK(hit.sphere == 1);
  CHECK(hit.root == 1);
  CHECK(decimal_text(hit.t) == "2.4");
  CHECK(text_of(hit.P) == "(0, -0.2, 2.4)");
  CHECK(text_of(hit.N) == "(0, 0.8, -0.6)");
  REQUIRE(chain.spheres.size() == 4);
  CHECK(chain.spheres[0].discriminant == mpq_class(16, 9));      // b = -37/6, 4ac = 1305/36
  CHECK(decimal_text(chain.spheres[0].roots[0]) == "3.724138");  // 108/29
  CHECK(chain.spheres[0].counts == std::array{true, true});
  CHECK(chain.spheres[1].discriminant < 0);

  REQUIRE(hit.lights.size() == 2);
  const LightMet& point = hit.lights[0];
  CHECK(point.index == 1);
  CHECK(point.shine == Shine::lit);
  CHECK(text_of(point.L) == "(2, 1.2, -2.4)");
  CHECK(decimal_text(point.N_dot_L) == "2.4");
  CHECK(decimal_text(point.L_length) == "3.346640");  // √11.2
  CHECK(decimal_text(point.term) == "0.4302823");     // 0.6 * 2.4 / √11.2
  CHECK(decimal_text(point.degrees) == "44.18138");
  const LightMet& directional = hit.lights[1];
  CHECK(decimal_text(directional.N_dot_L) == "0.8");
  CHECK(decimal_text(directional.term) == "0.02785242");  // 0.2 * 0.8 / √33
  CHECK(decimal_text(chain.I) == "0.6581347");
  CHECK(chain.bytes == std::array<std::uint8_t, 3>{168, 0, 0});
}

TEST_CASE("a stage sums its own terms") {
  const auto I = [](unsigned terms) {
    return decimal_text(certified_chain(lecture_scene(), terms, 300, 349).I);
  };
  CHECK(I(0) == "1");
  CHECK(I(ambient_term) == "0.2");
  CHECK(I(ambient_term | point_term) == "0.6302823");
  CHECK(I(ambient_term | directional_term) == "0.2278524");
}

TEST_CASE("a tangent ray hits, the sky is the background") {
  const Chain tangent = certified_chain(lecture_scene(), all_terms, 300, 299);
  CHECK(tangent.spheres[0].discriminant == 0);
  REQUIRE(tangent.hit.has_value());
  CHECK(decimal_text(tangent.hit->t) == "3");
  const Chain sky = certified_chain(lecture_scene(), all_terms, 300, 10);
  CHECK_FALSE(sky.hit.has_value());
  CHECK(sky.bytes == std::array<std::uint8_t, 3>{255, 255, 255});
  CHECK(decimal_text(sky.channels[0]) == "255");
}

TEST_CASE("t = 1 counts, and nothing before it") {
  const Chain chain = certified_chain(
      parse_scene_text("canvas_size = 2 x 2\n"
                       "sphere { center = (0, 0, 2) radius = 1 color = (9, 9, 9) }\n"
                       "sphere { center = (0, 0, 2) radius = 1.5 color = (9, 9, 9) }\n",
                       "test"),
      0, 1, 0);
  CHECK(chain.spheres[0].counts == std::array{true, true});
  CHECK(chain.spheres[1].counts == std::array{true, false});  // 0.5 and 3.5
  CHECK(chain.hit.value().sphere == 1);
}

TEST_CASE("lights from behind, from the side, and at P itself") {
  const SceneText scene = parse_scene_text(
      "canvas_size = 2 x 2\n"
      "sphere { center = (0, 0, 5) radius = 2 color = (255, 255, 255) }\n"
      "light { type = point intensity = 0.3 position = (0, 0, 3) }\n"
      "light { type = ambient intensity = 0.25 }\n"
      "light { type = directional intensity = 0.3 direction = (1, -1, 0) }\n"
      "light { type = directional intensity = 0.3 direction = (0, 0.3, 0.4) }\n"
      "light { type = directional intensity = 0.3 direction = (0, 0, -9) }\n",
      "test");
  const Chain chain = certified_chain(scene, all_terms, 1, 0);
  const std::vector<LightMet>& lights = chain.hit.value().lights;
  REQUIRE(lights.size() == 4);
  CHECK(lights[0].shine == Shine::at_P);
  CHECK(lights[1].shine == Shine::grazing);
  CHECK(lights[1].index == 2);
  CHECK(decimal_text(lights[1].degrees, 4) == "90.00");
  CHECK(lights[2].shine == Shine::behind);
  CHECK(decimal_text(lights[2].cosine) == "-0.8");
  CHECK(lights[2].term.high == 0);
  CHECK(decimal_text(lights[3].term) == "0.3");
  CHECK(decimal_text(lights[3].degrees) == "0");
  CHECK(chain.I.low == mpq_class(11, 20));
}

TEST_CASE("the chain is what the exact tracer finds, on every scene") {
  for (const SceneText& scene : all_scenes()) {
    INFO(scene.name);
    const reference::ExactScene exact = reference::to_exact(scene);
    long hits = 0;
    for_some_pixels(scene, 400, [&](int column, int row) {
      const Chain chain = certified_chain(scene, all_terms, column, row);
      const certified::ExactPixel pixel =
          certified::exact_pixel(exact, oracle_terms(all_terms), column, row, 60);
      bool right = (chain.hit ? chain.hit->sphere : 0) == pixel.sphere;
      if (chain.hit) {
        ++hits;
        Enclosure sum{exact.ambient, exact.ambient};
        for (const LightMet& light : chain.hit->lights) {
          sum = {sum.low + light.term.low, sum.high + light.term.high};
          right = right && is_narrow(light.term) && is_narrow(light.L_length);
        }
        right = right && meet(sum, pixel.I) && is_narrow(sum) && is_narrow(chain.hit->t);
        Enclosure N_squared{0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
          const Enclosure square = squared(chain.hit->N[i]);
          N_squared = {N_squared.low + square.low, N_squared.high + square.high};
          const mpq_class& O = exact.camera[i];
          const Enclosure P{O + std::min(mpq_class(chain.D[i] * chain.hit->t.low),
                                         mpq_class(chain.D[i] * chain.hit->t.high)),
                            O + std::max(mpq_class(chain.D[i] * chain.hit->t.low),
                                         mpq_class(chain.D[i] * chain.hit->t.high))};
          right = right && meet(P, chain.hit->P[i]) && is_narrow(chain.hit->P[i]);
        }
        right = right && meet(N_squared, {1, 1}) && is_narrow(N_squared);
      }
      if (!right) FAIL_CHECK("column " << column << ", row " << row);
    });
    CHECK(hits > 0);
  }
}
