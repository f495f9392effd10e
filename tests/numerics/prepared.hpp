// What a fixed camera allows: whatever hangs on the scene alone is computed once, in exact numbers,
// and rounded once. What is left for each pixel is less work, and less to go wrong.
//
// Everything is seen from the camera: P stands for P − O = t D.
#pragma once

#include <cmath>
#include <vector>

#include "canvas.hpp"
#include "fos/scene_text.hpp"
#include "slides.hpp"

namespace fos::numerics {

template <class T>
struct PreparedSphere {
  Vec<T> V;  ///< C − O
  T c;       ///< |V|² − r²: the slides lose most of its digits where |V| and r are large
  T inverse_r;
};

template <class T>
struct PreparedScene {
  int width = 0;
  int height = 0;
  T kx = 0;  ///< Vw / W
  T ky = 0;  ///< Vh / H
  T d = 1;   ///< the projection plane
  std::vector<PreparedSphere<T>> spheres;
  T ambient_intensity = 0;
  std::vector<LightOf<T>> point_lights;        ///< the vector is M = S − O
  std::vector<LightOf<T>> directional_lights;  ///< the vector is L / |L|
};

/// Each number the T nearest to its exact value. Throws std::range_error for numbers beyond
/// 10^±10000.
template <class T>
PreparedScene<T> prepare(const SceneText& text);

/// The sphere's t >= 1 that is nearest, or infinity.
///
/// With h = ⟨V,D⟩ the roots of a t² − 2 h t + c are q/a and c/q, q = h ± √(h² − a c) with the sign
/// of h, so that nothing cancels. Seen from outside, c/q is the near one. Seen from inside with h <
/// 0, c/q is the one in front of the camera. In the third case, inside with h >= 0, c/q < 0. So c/q
/// is tried first; where it lies before the plane t = 1 or behind the camera, it is q/a or none.
template <class T>
T nearest_root(T a, T h, T c) {
  const T discriminant = h * h - a * c;
  if (discriminant < 0) return std::numeric_limits<T>::infinity();
  const T q = h + std::copysign(std::sqrt(discriminant), h);
  T t = c / q;
  if (!(t >= 1)) t = q / a;
  return t >= 1 ? t : std::numeric_limits<T>::infinity();
}

template <class T>
T prepared_lighting(const Vec<T>& P, const Vec<T>& N, const PreparedScene<T>& scene) {
  T i = scene.ambient_intensity;
  for (const LightOf<T>& light : scene.point_lights) {
    const Vec<T> L = light.vector - P;
    const T n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += light.intensity * n_dot_l / std::sqrt(dot(L, L));
  }
  for (const LightOf<T>& light : scene.directional_lights) {
    const T n_dot_l = dot(N, light.vector);
    if (n_dot_l > 0) i += light.intensity * n_dot_l;
  }
  return i;
}

template <class T>
Seen<T> trace_prepared(const Vec<T>& D, const PreparedScene<T>& scene) {
  const T a = dot(D, D);
  T closest_t = std::numeric_limits<T>::infinity();
  const PreparedSphere<T>* closest = nullptr;
  for (const PreparedSphere<T>& sphere : scene.spheres) {
    const T t = nearest_root(a, dot(sphere.V, D), sphere.c);
    if (t < closest_t) closest_t = t, closest = &sphere;
  }
  if (closest == nullptr) return {};
  const Vec<T> P = closest_t * D;
  const Vec<T> N = (P - closest->V) * closest->inverse_r;
  return {static_cast<int>(closest - scene.spheres.data()) + 1, prepared_lighting(P, N, scene)};
}

template <class T>
void render_prepared(const PreparedScene<T>& scene, Canvas<T>& out) {
  const T middle = static_cast<T>(scene.width) / 2;
  const T top = static_cast<T>(scene.height) / 2 - 1;
  std::size_t i = 0;
  for (int row = 0; row < scene.height; ++row) {
    const T y = (top - static_cast<T>(row)) * scene.ky;
    for (int column = 0; column < scene.width; ++column, ++i) {
      const T x = (static_cast<T>(column) - middle) * scene.kx;
      const Seen<T> seen = trace_prepared<T>({x, y, scene.d}, scene);
      out.sphere[i] = seen.sphere;
      out.I[i] = seen.I;
    }
  }
}

}  // namespace fos::numerics
