// Certified pictures: the scenes that are committed, and random ones.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "catch2.hpp"
#include "certified_frame.hpp"
#include "compare.hpp"
#include "random_scene.hpp"

using namespace fos;
using namespace fos::certified;

namespace {

constexpr reference::Terms all_light =
    reference::ambient | reference::point | reference::directional;

SceneText scene_of(const std::string& lines) {
  return parse_scene_text("canvas_size = 24 x 24\n" + lines, "test");
}

Picture picture_of(const SceneText& scene, reference::Terms terms) {
  Picture picture;
  Renderer(scene, terms).render(picture);
  return picture;
}

}  // namespace

TEST_CASE("every committed scene, for every sum of terms, has the certified bytes") {
  for (const auto& file : std::filesystem::directory_iterator(FOS_REFERENCE_DATA)) {
    const reference::Reference reference = reference::read_reference(file.path());
    const SceneText scene = parse_scene_text(reference.scene_text, file.path().filename());
    const reference::ExactScene exact = reference::to_exact(scene);
    for (const reference::Terms terms : reference::all_terms) {
      INFO(file.path().filename().string() << ", terms " << terms);
      CHECK((picture_of(scene, terms).rgb == certified_frame(exact, reference, terms)));
    }
  }
}

TEST_CASE(
    "random scenes have the interval tracer's bytes, and the floats claim no more than holds") {
  for (std::uint64_t number = 0; number < 60; ++number) {
    const Comparison result =
        certified::compare(parse_scene_text(random_scene(number, 24), "random"), all_light);
    INFO("scene " << number << ": " << result.first);
    CHECK(result.is_sound());
  }
}

TEST_CASE("the plan changes no byte") {
  // Against the plan that decides nothing, which renders other pixels by other arithmetic.
  Effort planned;
  Effort general;
  const auto add = [](Effort& sum, const Effort& effort) {
    sum.in_float += effort.in_float;
    sum.in_double += effort.in_double;
    sum.exact += effort.exact;
  };
  for (std::uint64_t number = 0; number < 150; ++number) {
    INFO("scene " << number);
    const SceneText scene = parse_scene_text(random_scene(number, 24), "random");
    for (const reference::Terms terms : {reference::Terms{reference::ambient}, all_light}) {
      const Renderer renderer(scene, terms);
      Picture by_plan;
      Picture by_none;
      add(planned, renderer.render(by_plan));
      add(general, Renderer(scene, terms, general_plan(renderer.scene())).render(by_none));
      CHECK((by_plan.rgb == by_none.rgb));
    }
  }
  CHECK(planned.exact < general.exact);  // repeated spheres are ties for it
}

TEST_CASE("floats decide nearly all of an ordinary scene") {
  const SceneText scene = scene_of(
      "sphere { center = (0, -1, 3) radius = 1 color = (255, 0, 0) }\n"
      "sphere { center = (0, -5001, 0) radius = 5000 color = (255, 255, 0) }\n"
      "sphere { center = (0, 0, 2) radius = 40 color = (9, 200, 30) }\n"
      "light { type = ambient intensity = 0.2 }\n"
      "light { type = point intensity = 0.6 position = (2, 1, 0) }\n");
  Picture picture;
  const Effort effort = Renderer(scene, all_light).render(picture);
  CHECK(effort.in_float + effort.in_double + effort.exact == 576);  // all
  CHECK(effort.in_float > 560);
}

TEST_CASE("what a scene requires") {
  const auto plan_of = [](const std::string& lines, reference::Terms terms = all_light) {
    return Renderer(scene_of(lines), terms).plan();
  };
  const std::string seen = "sphere { center = (0, 0, 3) radius = 1 color = (1, 2, 3) }\n";

  SECTION("spheres that cannot be seen are left out") {
    CHECK(plan_of(seen).spheres.size() == 1);
    for (const std::string unseen :
         {"sphere { center = (0, 0, -3) radius = 1 color = (1, 2, 3) }",      // behind
          "sphere { center = (0, 0, 0.2) radius = 0.7 color = (1, 2, 3) }",   // before t = 1
          "sphere { center = (9, 0, 3) radius = 1 color = (1, 2, 3) }",       // to the right
          "sphere { center = (0, -9, 3) radius = 1 color = (1, 2, 3) }",      // below
          "sphere { center = (0, 0, 3) radius = 1 color = (200, 2, 3) }"}) {  // the same again
      INFO(unseen);
      CHECK(plan_of(seen + unseen).spheres.size() == 1);
    }
    // It reaches t = 1 exactly, in one point.
    CHECK(plan_of("sphere { center = (0, 0, 0) radius = 1 color = (1, 2, 3) }").spheres.size() ==
          1);
  }
  SECTION("normals are needed where a light but the ambient shines") {
    const std::string ambient = "light { type = ambient intensity = 0.2 }\n";
    const std::string point = "light { type = point intensity = 0.5 position = (2, 1, 0) }\n";
    CHECK_FALSE(plan_of(seen + ambient).shade);
    CHECK(plan_of(seen + point).shade);
    CHECK_FALSE(plan_of(seen + point, reference::ambient | reference::directional).shade);
    CHECK_FALSE(plan_of(seen + "light { type = point intensity = 0 position = (2, 1, 0) }").shade);
  }
  SECTION("a point light far enough is a directional one") {
    const auto replaced = [&](const std::string& z) {
      return plan_of(seen + "light { type = point intensity = 0.5 position = (0, 0, -" + z + ") }")
          .replaced.at(0);
    };
    CHECK(replaced("100") < 0);
    CHECK(replaced("1e6") < 0);
    // √(9 − 1) / 1e8
    CHECK_THAT(replaced("1e8"), WithinAbs(std::sqrt(8.0) / 1e8, 1e-16));
    CHECK(replaced("1e400") == 0);
  }
}

TEST_CASE("a replaced light reaches the far side of a sphere too") {
  // The camera almost touches the sphere, so that its tangents are short, and sees its far side.
  const Comparison result = certified::compare(
      scene_of("sphere { center = (0, 0, 2) radius = 1.9999 color = (255, 90, 255) }\n"
               "light { type = point intensity = 0.9 position = (80000, 5000, 60000) }\n"),
      all_light);
  INFO(result.first);
  CHECK(result.is_sound());
}

TEST_CASE("the replacement's bound holds, and is not twice too large") {
  // The worst surface point: at the reach, across the light's direction, its normal turned so that
  // ⟨N,L⟩ changes fastest.
  for (const double distance : {2.0, 10.0, 1e3, 1e6}) {
    const double turned = std::asin(1 / distance);  // between L and its replacement
    const double worst = 2 * std::sin(turned / 2);  // N along their difference
    CHECK(replacement_bound(1, distance) >= worst);
    CHECK(replacement_bound(1, distance) <= 1.1 * worst);
  }
  CHECK(replacement_bound(3, 2) == 2);
}
