// Right programs in other formulations: FOS_FORMULATION names one. All of them must pass, at every
// precision: the rule judges the pixels, not the way.
#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "fos/stage.hpp"

namespace fos {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

const std::string_view formulation = variable("FOS_FORMULATION");
const std::string_view terms = variable("FOS_TERMS");  // some of "apd", or "1" for the plain color

bool is(std::string_view name) { return formulation == name; }

/// A name that is spelt wrong must not pass as the formulation of the slides.
const bool known = [] {
  constexpr std::string_view names[] = {
      "as_on_the_slides",    "half_b",           "geometric",       "normalised_D",
      "normalised_D_simply", "factored_c",       "stable_root",     "fma",
      "max_with_0",          "normalised_L",     "sqrt_of_squares", "N_over_r",
      "N_not_normalised",    "lights_backwards", "color_per_light", "clamped",
      "static_lights",       "float_throughout"};
  if (std::find(std::begin(names), std::end(names), formulation) == std::end(names)) std::abort();
  return true;
}();
bool has(char term) { return terms.find(term) != std::string_view::npos; }

struct Roots {
  Real t1, t2;
};

std::optional<Roots> roots(const Vec3& O, const Vec3& D, const Sphere& sphere) {
  const Vec3 CO = O - sphere.center;
  const Real r = sphere.radius;
  if (is("half_b")) {
    const Real a = dot(D, D);
    const Real h = dot(CO, D);
    const Real disc = h * h - a * (dot(CO, CO) - r * r);
    if (disc < 0) return std::nullopt;
    return Roots{(-h + std::sqrt(disc)) / a, (-h - std::sqrt(disc)) / a};
  }
  if (is("geometric")) {  // the nearest point to the centre, then half the chord
    const Real middle = -dot(CO, D) / dot(D, D);
    const Vec3 l = CO + middle * D;
    const Real chord = r * r - dot(l, l);
    if (chord < 0) return std::nullopt;
    const Real half = std::sqrt(chord) / length(D);
    return Roots{middle + half, middle - half};
  }
  if (is("normalised_D")) {  // t is a distance then, and is turned back
    const Vec3 d = normalize(D);
    const Real h = dot(CO, d);
    const Real disc = h * h - (dot(CO, CO) - r * r);
    if (disc < 0) return std::nullopt;
    return Roots{(-h + std::sqrt(disc)) / length(D), (-h - std::sqrt(disc)) / length(D)};
  }
  const Real a = dot(D, D);
  const Real b = 2 * dot(CO, D);
  const Real c = is("factored_c") ? (length(CO) - r) * (length(CO) + r) : dot(CO, CO) - r * r;
  const Real disc = is("fma") ? std::fma(b, b, -4 * a * c) : b * b - 4 * a * c;
  if (disc < 0) return std::nullopt;
  if (is("stable_root")) {
    const Real q = -(b + std::copysign(std::sqrt(disc), b)) / 2;
    return Roots{q / a, q == 0 ? 0 : c / q};
  }
  return Roots{(-b + std::sqrt(disc)) / (2 * a), (-b - std::sqrt(disc)) / (2 * a)};
}

Real cosine(const Vec3& N, const Vec3& L) {
  if (is("max_with_0")) return length(L) > 0 ? std::max<Real>(0, dot(N, L) / length(L)) : 0;
  if (is("normalised_L")) {
    const Real n_dot_l = length(L) > 0 ? dot(N, normalize(L)) : 0;
    return n_dot_l > 0 ? n_dot_l : 0;
  }
  const Real n_dot_l = dot(N, L);
  if (!(n_dot_l > 0)) return 0;
  if (is("sqrt_of_squares")) return n_dot_l / std::sqrt(dot(N, N) * dot(L, L));
  return n_dot_l / (length(N) * length(L));
}

Color shade(const Vec3& P, const Sphere& sphere, const Scene& scene) {
  if (has('1')) return sphere.color;
  const Vec3 CP = P - sphere.center;
  const Vec3 N = is("N_over_r")           ? CP / sphere.radius
                 : is("N_not_normalised") ? CP  // right all the same: the formula divides by |N|
                                          : normalize(CP);
  std::vector<Real> parts;
  if (has('a')) parts.push_back(scene.ambient_intensity);
  if (has('p')) {
    for (const PointLight& light : scene.point_lights) {
      parts.push_back(light.intensity * cosine(N, light.position - P));
    }
  }
  if (has('d')) {
    // A stage may keep statics: a frame is one scene.
    static const std::vector<DirectionalLight> kept = scene.directional_lights;
    for (const auto& light : is("static_lights") ? kept : scene.directional_lights) {
      parts.push_back(light.intensity * cosine(N, light.direction));
    }
  }
  if (is("lights_backwards")) std::reverse(parts.begin(), parts.end());
  if (is("color_per_light")) {
    Color sum(0);
    for (const Real part : parts) sum += sphere.color * part;
    return sum;
  }
  Real I = 0;
  for (const Real part : parts) I += part;
  const Color color = I * sphere.color;
  return is("clamped") ? min(color, Color(255)) : color;
}

/// The slides' code with float for every number and vector, in a program of any precision: what a
/// student writes who is used to shaders. It is right to float precision, and passes with a note.
Color trace_in_float(const Vec3& given_O, const Vec3& given_D, Real t_min, Real t_max,
                     const Scene& scene) {
  using FloatVec = glm::vec<3, float>;
  const FloatVec O(given_O);
  const FloatVec D(given_D);
  float closest_t = std::numeric_limits<float>::infinity();
  const Sphere* closest = nullptr;
  for (const Sphere& sphere : scene.spheres) {
    const FloatVec CO = O - FloatVec(sphere.center);
    const auto r = static_cast<float>(sphere.radius);
    const float a = dot(D, D);
    const float b = 2 * dot(CO, D);
    const float c = dot(CO, CO) - r * r;
    const float disc = b * b - 4 * a * c;
    if (disc < 0) continue;
    for (const float root : {-std::sqrt(disc), std::sqrt(disc)}) {
      const float t = (-b + root) / (2 * a);
      if (t_min <= t && t <= t_max && t < closest_t) closest_t = t, closest = &sphere;
    }
  }
  if (closest == nullptr) return scene.background_color;
  if (has('1')) return closest->color;
  const FloatVec P = O + closest_t * D;
  FloatVec N = P - FloatVec(closest->center);
  N = N / length(N);
  auto I = has('a') ? static_cast<float>(scene.ambient_intensity) : 0.0F;
  const auto add = [&](Real intensity, const FloatVec& L) {
    const float n_dot_l = dot(N, L);
    if (n_dot_l > 0) I += static_cast<float>(intensity) * n_dot_l / (length(N) * length(L));
  };
  if (has('p')) {
    for (const auto& light : scene.point_lights) add(light.intensity, FloatVec(light.position) - P);
  }
  if (has('d')) {
    for (const auto& light : scene.directional_lights) {
      add(light.intensity, FloatVec(light.direction));
    }
  }
  return Color(FloatVec(closest->color) * I);
}

}  // namespace

Color trace_ray(const Vec3& O, const Vec3& given_D, Real t_min, Real t_max, const Scene& scene) {
  if (is("float_throughout")) return trace_in_float(O, given_D, t_min, t_max, scene);
  // Its t is a distance, of which [1, infinity] is a little more than what the camera asks for: no
  // scene has anything in between.
  const Vec3 D = is("normalised_D_simply") ? normalize(given_D) : given_D;
  Real closest_t = infinity;
  const Sphere* closest = nullptr;
  for (const Sphere& sphere : scene.spheres) {
    const auto both = roots(O, D, sphere);
    if (!both) continue;
    for (const Real t : {both->t1, both->t2}) {
      if (t_min <= t && t <= t_max && t < closest_t) closest_t = t, closest = &sphere;
    }
  }
  return closest == nullptr ? scene.background_color : shade(O + closest_t * D, *closest, scene);
}

}  // namespace fos
