// What a point light far away comes to: fading with distance, and L = S − P that no longer depends
// on P.
#include "extremes_families.hpp"
#include "light_going_away.hpp"
#include "scene_parts.hpp"

namespace fos::numerics {
namespace {

constexpr int side = 49;  // odd: no ray is exactly tangent

std::string lit_from(int k) {
  return canvas(side, side) + lecture_spheres() + ambient("0.2") +
         point("0.6", times_power(1, 4, 4, k));
}

/// I grows with the square of the light's distance, so that it is the same at the origin.
template <class T>
T fading(const SceneOf<T>& /*scene*/, const SeenPoint<T>& seen) {
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
  const auto point = all_pixels<T>(text, [](const SceneOf<T>&, const SeenPoint<T>& seen) {
    return cosine(seen, seen.S - seen.P);
  });
  const auto directional = all_pixels<T>(
      text, [](const SceneOf<T>&, const SeenPoint<T>& seen) { return cosine(seen, seen.S); });
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

}  // namespace

Family light_going_away(std::string_view id, Text title, Text finding,
                        std::vector<std::string_view> ways, std::vector<int> powers,
                        std::vector<Line> (*ask)(const SceneText&)) {
  Family family{id, title, finding, std::move(ways), {}, {}};
  for (const int k : powers) family.parameters.push_back(power(k));
  family.ask = [powers = std::move(powers), ask](std::size_t i) {
    return ask(parse_scene_text(lit_from(powers[i]), power(powers[i])));
  };
  return family;
}

Truth truth_with(const SceneText& text, const std::vector<Said>& said) {
  Truth truth = truth_of(text);
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (truth.pixels[i].sphere != 0) truth.pixels[i].I = {said[i].I, 0};
  }
  return truth;
}

Family falloff() {
  return light_going_away(
      "falloff", text::extremes_falloff, text::extremes_falloff_finding, {"d²/|L|²"},
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
  return light_going_away(
      "lost_P", text::extremes_lost_P, text::extremes_lost_P_finding, {"difference"},
      {0, 2, 4, 6, 7, 8, 9, 10, 12, 14, 16, 17, 18, 19, 20, 21, 22}, [](const SceneText& text) {
        return std::vector{lost_line<float>(text, Precision::binary32),
                           lost_line<double>(text, Precision::binary64),
                           lost_line<long double>(text, Precision::extended)};
      });
}

}  // namespace fos::numerics
