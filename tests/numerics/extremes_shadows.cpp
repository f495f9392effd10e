// Where the slides' warning about the sun does bite: with shadows, which lecture 4 leaves out.
#include "extremes_families.hpp"
#include "light_going_away.hpp"

namespace fos::numerics {
namespace {

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

/// The usual shadow ray, from P along L = S − P, with t in [t_min, 1].
template <class T>
auto from_P(T t_min_times_L) {
  return [=](const SceneOf<T>& scene, const SeenPoint<T>& seen) -> T {
    const Vec<T> L = seen.S - seen.P;
    const T t_min = t_min_times_L > 0 ? t_min_times_L / length(L) : T(0.001L);
    return meets<T>(seen.P, L, t_min, 1, scene) ? 0 : cosine(seen, L);
  };
}

/// Seen from the light: P has light if its sphere is the first on the way.
template <class T>
T from_light(const SceneOf<T>& scene, const SeenPoint<T>& seen) {
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
T other_spheres_only(const SceneOf<T>& scene, const SeenPoint<T>& seen) {
  const Vec<T> L = seen.S - seen.P;
  return meets<T>(seen.P, L, 0, 1, scene, seen.sphere) ? 0 : cosine(seen, L);
}

template <class T>
Line shadow_line(const SceneText& text, const Measure& measure, Precision precision) {
  return {text.name,
          precision,
          {{measure(all_pixels<T>(text, from_P<T>(0))), {}, 0},
           {measure(all_pixels<T>(text, from_P<T>(T(0.001L)))), {}, 0},
           {measure(all_pixels<T>(text, from_light<T>)), {}, 0}}};
}

}  // namespace

Family shadows() {
  return light_going_away(
      "shadows", text::extremes_shadows, text::extremes_shadows_finding,
      {"t >= 0.001", "t|L| >= 0.001", "from S"}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18},
      [](const SceneText& text) {
        using Long = long double;
        const Truth truth = truth_with(text, all_pixels<Long>(text, other_spheres_only<Long>));
        const Measure measure(text, truth);
        return std::vector{shadow_line<float>(text, measure, Precision::binary32),
                           shadow_line<double>(text, measure, Precision::binary64),
                           shadow_line<Long>(text, measure, Precision::extended)};
      });
}

}  // namespace fos::numerics
