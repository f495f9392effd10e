// The lecture's scene in a light that goes away: what is seen at a pixel, for models of light that
// the slides leave out.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "extremes_errors.hpp"
#include "slides.hpp"

namespace fos::numerics {

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

/// What the camera sees at a pixel, and the light's position S.
template <class T>
struct SeenPoint {
  int sphere;  ///< from 0; -1 is the background
  Vec<T> P, N, S;
};
template <class T>
SeenPoint<T> view(const SceneOf<T>& scene, int column, int row) {
  const Vec<T> D = canvas_to_viewport(scene, column, row);
  SeenPoint<T> seen{-1, Vec<T>(0), Vec<T>(0), scene.point_lights[0].vector};
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
T cosine(const SeenPoint<T>& seen, const Vec<T>& L) {
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
      const SeenPoint<T> seen = view(scene, column, row);
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

/// A family whose parameter is the light's place: (1, 4, 4) times these powers of ten, on a canvas
/// without a ray that is exactly tangent to a sphere.
Family light_going_away(std::string_view id, Text title, Text finding,
                        std::vector<std::string_view> ways, std::vector<int> powers,
                        std::vector<Line> (*ask)(const SceneText&));

/// The truth about the spheres, with the I of `said`, which is by long double.
Truth truth_with(const SceneText& text, const std::vector<Said>& said);

}  // namespace fos::numerics
