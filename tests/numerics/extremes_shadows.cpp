// Where the slides' warning about the sun does bite: with shadows, which lecture 4 leaves out; and
// what it comes to without: L = S − P that no longer depends on P, and light that fades.
#include <cmath>
#include <optional>

#include "extremes_errors.hpp"
#include "extremes_families.hpp"
#include "scene_parts.hpp"
#include "slides.hpp"

namespace fos::numerics {
namespace {

constexpr int side = 49;  // odd: no ray is exactly tangent

std::string lit_from(int k) {
  return canvas(side, side) + lecture_spheres() + ambient("0.2") +
         point("0.6", times_power(1, 4, 4, k));
}

/// The roots in closest_hit's form, so that what is lost is not b² − 4ac's doing.
template <class T>
std::optional<std::pair<T, T>> roots(const Vec<T>& O, const Vec<T>& D, const SphereOf<T>& sphere) {
  const Vec<T> V = sphere.center - O;
  const T a = dot(D, D);
  const T h = dot(V, D);
  const Vec<T> l = V - (h / a) * D;
  const T disc = sphere.radius * sphere.radius - dot(l, l);
  if (!(disc >= 0)) return std::nullopt;
  const T q = h + std::copysign(std::sqrt(a * disc), h);
  const T c = dot(V, V) - sphere.radius * sphere.radius;
  return std::minmax(q == 0 ? T{0} : c / q, q / a);
}

/// A sphere that the ray meets with t in [t_min, t_max], other than `except`.
template <class T>
bool meets(const Vec<T>& O, const Vec<T>& D, T t_min, T t_max, const SceneOf<T>& scene,
           int except = -1) {
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    if (static_cast<int>(i) == except) continue;
    const auto t = roots(O, D, scene.spheres[i]);
    if (!t) continue;
    if (t_min <= t->first && t->first <= t_max) return true;
    if (t_min <= t->second && t->second <= t_max) return true;
  }
  return false;
}

/// What the camera sees at a pixel, and the light's position S.
template <class T>
struct View {
  int sphere;  ///< from 0; -1 is the background
  Vec<T> P, N, S;
};
template <class T>
View<T> view(const SceneOf<T>& scene, int column, int row) {
  const Vec<T> D = canvas_to_viewport(scene, column, row);
  View<T> seen{-1, Vec<T>(0), Vec<T>(0), scene.point_lights[0].vector};
  T closest = std::numeric_limits<T>::infinity();
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const auto t = roots(scene.O, D, scene.spheres[i]);
    if (t && t->first >= 1 && t->first < closest) {
      closest = t->first;
      seen.sphere = static_cast<int>(i);
    }
  }
  if (seen.sphere < 0) return seen;
  seen.P = scene.O + closest * D;
  seen.N = seen.P - scene.spheres[static_cast<std::size_t>(seen.sphere)].center;
  seen.N = seen.N / length(seen.N);
  return seen;
}

template <class T>
T cosine(const View<T>& seen, const Vec<T>& L) {
  const T n_dot_l = dot(seen.N, L);
  return n_dot_l > 0 ? n_dot_l / (length(seen.N) * length(L)) : 0;
}

/// Every pixel, with the light's term times a factor.
template <class T, class Factor>
std::vector<Said> all_pixels(const SceneText& text, Factor factor) {
  const SceneOf<T> scene = rounded<T>(text);
  std::vector<Said> all;
  for (int row = 0; row < scene.height; ++row) {
    for (int column = 0; column < scene.width; ++column) {
      const View<T> seen = view(scene, column, row);
      if (seen.sphere < 0) {
        all.push_back({});
        continue;
      }
      const T I = scene.ambient_intensity + scene.point_lights[0].intensity * factor(scene, seen);
      all.push_back({seen.sphere + 1, I, std::isfinite(255 * I)});
    }
  }
  return all;
}

/// The usual shadow ray, from P along L = S − P, with t in [t_min, 1].
template <class T>
auto from_P(T t_min_times_L) {
  return [=](const SceneOf<T>& scene, const View<T>& seen) -> T {
    const Vec<T> L = seen.S - seen.P;
    const T t_min = t_min_times_L > 0 ? t_min_times_L / length(L) : T(0.001L);
    return meets<T>(seen.P, L, t_min, 1, scene) ? 0 : cosine(seen, L);
  };
}

/// Seen from the light: P has light if its sphere is the first on the way.
template <class T>
T from_light(const SceneOf<T>& scene, const View<T>& seen) {
  const Vec<T> D = seen.P - seen.S;
  int closest = -1;
  T closest_t = std::numeric_limits<T>::infinity();
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const auto t = roots(seen.S, D, scene.spheres[i]);
    if (t && t->first < closest_t) closest_t = t->first, closest = static_cast<int>(i);
  }
  return closest == seen.sphere ? cosine(seen, -D) : 0;
}

/// What is right: only another sphere can stand between, anywhere before the light.
template <class T>
T other_spheres_only(const SceneOf<T>& scene, const View<T>& seen) {
  const Vec<T> L = seen.S - seen.P;
  return meets<T>(seen.P, L, 0, 1, scene, seen.sphere) ? 0 : cosine(seen, L);
}

/// The truth with the terms of `said`, which is by long double.
Truth truth_with(const SceneText& text, const std::vector<Said>& said) {
  Truth truth = truth_of(text);
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (truth.pixels[i].sphere != 0) truth.pixels[i].I = {said[i].I, 0};
  }
  return truth;
}

template <class T>
Line shadow_line(const SceneText& text, const Measure& measure, Precision precision) {
  return {text.name,
          precision,
          {{measure(all_pixels<T>(text, from_P<T>(0))), {}, 0},
           {measure(all_pixels<T>(text, from_P<T>(T(0.001L)))), {}, 0},
           {measure(all_pixels<T>(text, from_light<T>)), {}, 0}}};
}

/// I grows with the square of the light's distance, so that it is the same at the origin.
template <class T>
T fading(const SceneOf<T>& /*scene*/, const View<T>& seen) {
  const Vec<T> L = seen.S - seen.P;
  return dot(seen.S, seen.S) / dot(L, L) * cosine(seen, L);
}

template <class T>
Line fading_line(const SceneText& text, const Measure& measure, Precision precision) {
  return {text.name, precision, {{measure(all_pixels<T>(text, fading<T>)), {}, 0}}};
}

/// The point light against the directional one whose L is S, at the same precision: `wrong_bytes`
/// are the pixels of which any bit differs.
template <class T>
Line lost_line(const SceneText& text, Precision precision) {
  const auto point = all_pixels<T>(
      text, [](const SceneOf<T>&, const View<T>& seen) { return cosine(seen, seen.S - seen.P); });
  const auto directional = all_pixels<T>(
      text, [](const SceneOf<T>&, const View<T>& seen) { return cosine(seen, seen.S); });
  Errors errors;
  errors.pixels = static_cast<long>(point.size());
  long double sum = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const long double difference = std::abs(point[i].I - directional[i].I);
    errors.max = std::max(errors.max, static_cast<double>(difference));
    sum += difference;
    if (difference != 0) ++errors.wrong_bytes;
  }
  errors.mean = static_cast<double>(sum / static_cast<long double>(point.size()));
  return {text.name, precision, {{errors, {}, 0}}};
}

Family sweep(std::string_view id, Text title, Text finding, std::vector<std::string_view> ways,
             std::vector<int> powers, std::vector<Line> (*ask)(const SceneText&)) {
  Family family{id, title, finding, std::move(ways), {}, {}};
  for (const int k : powers) family.parameters.push_back(power(k));
  family.ask = [powers = std::move(powers), ask](std::size_t i) {
    return ask(parse_scene_text(lit_from(powers[i]), power(powers[i])));
  };
  return family;
}

}  // namespace

Family shadows() {
  return sweep("shadows", text::extremes_shadows, text::extremes_shadows_finding,
               {"t >= 0.001", "t|L| >= 0.001", "from S"},
               {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18}, [](const SceneText& text) {
                 using Long = long double;
                 const Truth truth =
                     truth_with(text, all_pixels<Long>(text, other_spheres_only<Long>));
                 const Measure measure(text, truth);
                 return std::vector{shadow_line<float>(text, measure, Precision::binary32),
                                    shadow_line<double>(text, measure, Precision::binary64),
                                    shadow_line<Long>(text, measure, Precision::extended)};
               });
}

Family falloff() {
  return sweep("falloff", text::extremes_falloff, text::extremes_falloff_finding, {"d²/|L|²"},
               {0, 1, 2, 4, 8, 12, 16, 18, 19, 30, 100, 153, 154, 300}, [](const SceneText& text) {
                 using Long = long double;
                 const Truth truth = truth_with(text, all_pixels<Long>(text, fading<Long>));
                 const Measure measure(text, truth);
                 return std::vector{fading_line<float>(text, measure, Precision::binary32),
                                    fading_line<double>(text, measure, Precision::binary64),
                                    fading_line<Long>(text, measure, Precision::extended)};
               });
}

Family lost_P() {
  return sweep("lost_P", text::extremes_lost_P, text::extremes_lost_P_finding, {"difference"},
               {0, 2, 4, 6, 7, 8, 9, 10, 12, 14, 16, 17, 18, 19, 20, 21, 22},
               [](const SceneText& text) {
                 return std::vector{lost_line<float>(text, Precision::binary32),
                                    lost_line<double>(text, Precision::binary64),
                                    lost_line<long double>(text, Precision::extended)};
               });
}

}  // namespace fos::numerics
