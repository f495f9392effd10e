// Wrong programs: FOS_MISTAKE names what is wrong with this one, a mistake of the catalogue
// (tests/misconceptions), two of them with a comma between, or one of those below, which no student
// makes but a test could miss. All of them must fail.
#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <string_view>

#include "fos/stage.hpp"
#include "mistaken_tracer.hpp"

namespace fos {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

const std::string_view mistake = variable("FOS_MISTAKE");
bool is(std::string_view name) { return mistake == name; }

constexpr std::string_view technical[] = {
    "none",          "ambient_twice_alone",   "lit_without_lights", "light_moved",  "three_lights",
    "eight_spheres", "centre_behind_skipped", "whole_background",   "t_min_nearly", "far_is_1000",
    "gamma",         "a_percent_more",        "hue_kept",           "rounded",      "not_a_number"};

/// A name that is spelt wrong must not fail for that.
const MistakeSet mistakes = [] {
  MistakeSet set;
  if (std::find(std::begin(technical), std::end(technical), mistake) != std::end(technical)) {
    return set;
  }
  for (std::string_view rest = mistake; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const auto found = find_mistake(rest.substr(0, comma));
    if (!found) std::abort();
    set.add(*found);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return set;
}();

const unsigned terms = [] {  // some of "apd", or "1" for the plain color
  const std::string_view letters = variable("FOS_TERMS");
  const auto has = [&](char letter) { return letters.find(letter) != std::string_view::npos; };
  return (has('a') ? ambient_term : 0U) | (has('p') ? point_term : 0U) |
         (has('d') ? directional_term : 0U);
}();

/// The wrong scene.
Scene changed(Scene scene, const Vec3& O) {
  const bool dark = scene.point_lights.empty() && scene.directional_lights.empty();
  if (is("ambient_twice_alone") && dark) scene.ambient_intensity *= 2;
  if (is("lit_without_lights") && dark && scene.ambient_intensity == 0) scene.ambient_intensity = 1;
  for (PointLight& light : scene.point_lights) {
    if (is("light_moved")) {
      light.position.x += Real(0.02) * std::max<Real>(1, std::abs(light.position.x));
    }
  }
  if (is("three_lights")) {
    const std::size_t points = (terms & point_term) != 0 ? scene.point_lights.size() : 0;
    const std::size_t left = 3 - std::min<std::size_t>(3, points);
    scene.point_lights.resize(std::min<std::size_t>(3, scene.point_lights.size()));
    scene.directional_lights.resize(std::min(left, scene.directional_lights.size()));
  }
  if (is("eight_spheres") && scene.spheres.size() > 8) scene.spheres.resize(8);
  if (is("centre_behind_skipped")) {
    std::erase_if(scene.spheres, [&](const Sphere& sphere) { return sphere.center.z < O.z; });
  }
  if (is("whole_background")) scene.background_color = floor(scene.background_color);
  return scene;
}

/// The wrong color.
Color changed(Color color) {
  if (is("a_percent_more")) color *= Real(1.01);
  const Real brightest = std::max({color.r, color.g, color.b});
  if (is("hue_kept") && brightest > 255) color = color * (255 / brightest);
  if (is("rounded")) color = round(color);
  if (is("not_a_number")) color.g += std::sqrt(color.r - 10) * 0;
  return color;
}

}  // namespace

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  if (is("t_min_nearly")) t_min = Real(0.9);
  if (is("far_is_1000")) t_max = 1000;
  const Scene its = changed(scene, O);
  const auto seen = MistakenTracer<Real, Scene>(its, terms, mistakes).trace(O, D, t_min, t_max);
  if (seen.sphere == 0) return seen.color;
  const Color& color = its.spheres[static_cast<std::size_t>(seen.sphere) - 1].color;
  if (is("gamma")) return color * std::sqrt(std::max<Real>(0, seen.I));
  return changed(seen.color);
}

}  // namespace fos
