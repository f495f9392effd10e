// The remedies that cost nothing per pixel, each beside the formula without it, which breaks on the
// same scene.
#include <algorithm>

#include "catch2.hpp"
#include "fos/scene_file.hpp"
#include "scene_of_any_size.hpp"
#include "slides.hpp"

using namespace fos;
using numerics::refusal;

namespace {

SceneText scene(const std::string& light) {
  return parse_scene_text(
      "canvas_size = 2 x 2\nsphere { center = (0, 0, 3) radius = 1 color = (255, 0, 0) }\n" + light,
      "f");
}

/// I straight ahead, where P = (0, 0, 2) and N = (0, 0, -1), by the slides' formulas on a scene as
/// it is, and on what to_scene makes of it.
template <class T = Real>
T as_written(const SceneText& text) {
  const auto raw = numerics::rounded<T>(text);
  return numerics::trace_ray(numerics::canvas_to_viewport(raw, 1, 0), raw).I;
}
Real as_read(const SceneText& text) {
  const Scene read = to_scene(text).scene;
  numerics::SceneOf<Real> raw = numerics::rounded<Real>(text);
  raw.directional_lights.clear();
  for (const auto& light : read.directional_lights) {
    raw.directional_lights.push_back({light.intensity, light.direction});
  }
  return numerics::trace_ray(numerics::canvas_to_viewport(raw, 1, 0), raw).I;
}

std::string power(double share) {
  return "e" + std::to_string(static_cast<int>(share * std::numeric_limits<Real>::max_exponent10));
}
bool is_half(Real I) { return std::abs(I - Real(0.5)) < 4 * std::numeric_limits<Real>::epsilon(); }

}  // namespace

TEST_CASE("a direction of any length is rescaled; as written it goes dark or infinite") {
  for (const double share : {-0.9, -0.6, 0.0, 0.6, 0.9}) {
    const std::string e = power(share);
    INFO(e);
    // cos = 3/5.
    const SceneText text = scene(
        "light { type = directional intensity = 0.8333333333333333333333 "
        "direction = (4" +
        e + ", 0, -3" + e + ") }");
    CHECK(is_half(as_read(text)));
    CHECK(is_half(as_written(text)) == (share == 0));
  }
}

TEST_CASE("a light too far for Real is refused, with the directional light that is right") {
  const std::string e = power(0.55);
  const SceneText text =
      scene("light { type = point intensity = 0.5 position = (0, 0, -2" + e + ") }");
  CHECK(as_written(text) == 0);  // silently dark
  const std::string words = refusal(text);
  const std::string light = "light { type = directional  intensity = 0.5  direction = (0, 0, -2) }";
  CHECK_THAT(words, ContainsSubstring(light));
  CHECK(is_half(as_read(scene(light))));
}

TEST_CASE("a light at P: `if` and max(0, x) give no light, max(x, 0) gives NaN") {
  const SceneText text = scene("light { type = point intensity = 1 position = (0, 0, 2) }");
  CHECK(as_written(text) == 0);
  const Vec3 N(0, 0, -1);
  const Vec3 L(0);
  const Real x = dot(N, L) / (length(N) * length(L));
  CHECK(std::isnan(x));
  CHECK(std::max<Real>(0, x) == 0);
  CHECK(std::isnan(std::max<Real>(x, 0)));
}

TEST_CASE("an intensity that makes color I infinite is refused: 0 times infinity is no color") {
  const SceneText text = scene("light { type = ambient intensity = 1" + power(1) + " }");
  const Real I = as_written(text);
  CHECK(std::isfinite(I));
  CHECK(!std::isfinite(255 * I));
  CHECK(std::isnan(0 * (255 * I)));
  CHECK_THAT(refusal(text), ContainsSubstring("'intensity' is too large"));
}
