// The rungs that follow the slides: in one type throughout, and with one thing changed each.
#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "canvas.hpp"
#include "slides.hpp"

namespace fos::numerics {

/// Calls `see(column, row)` for every pixel and keeps the sphere and the light that it answers.
template <class T, class See>
void for_each_pixel(Canvas<T>& out, const See& see) {
  std::size_t i = 0;
  for (int row = 0; row < out.height; ++row) {
    for (int column = 0; column < out.width; ++column, ++i) {
      const Seen<T> seen = see(column, row);
      out.sphere[i] = seen.sphere;
      out.I[i] = seen.I;
    }
  }
}

/// As on the slides.
template <class T>
void render_slides(const SceneOf<T>& scene, Canvas<T>& out) {
  for_each_pixel(out, [&](int column, int row) {
    return trace_ray(canvas_to_viewport(scene, column, row), scene);
  });
}

/// Mixed: t and P in double, what the light makes of P in float.
inline void render_mixed(const SceneOf<double>& scene, const SceneOf<float>& shading,
                         Canvas<float>& out) {
  for_each_pixel(out, [&](int column, int row) -> Seen<float> {
    const Vec<double> D = canvas_to_viewport(scene, column, row);
    const auto [t, i] = closest_sphere(scene.O, D, scene);
    if (i < 0) return {};
    const Vec<float> P(scene.O + t * D);
    Vec<float> N = P - shading.spheres[static_cast<std::size_t>(i)].center;
    N = N / length(N);
    return {i + 1, compute_lighting(P, N, shading)};
  });
}

#ifdef __SSE__
/// 1/√x to about 12 bits, relative error at most 1.5 · 2^-12, by one instruction.
inline float approximate_rsqrt(float x) { return _mm_cvtss_f32(_mm_rsqrt_ss(_mm_set_ss(x))); }

/// ComputeLighting with 1/|N| and 1/|L| by that instruction.
inline float approximate_lighting(const Vec<float>& P, const Vec<float>& N,
                                  const SceneOf<float>& scene) {
  float i = scene.ambient_intensity;
  const auto add = [&](float intensity, const Vec<float>& L) {
    const float n_dot_l = dot(N, L);
    if (n_dot_l > 0) {
      i += intensity * n_dot_l * (approximate_rsqrt(dot(N, N)) * approximate_rsqrt(dot(L, L)));
    }
  };
  for (const LightOf<float>& light : scene.point_lights) add(light.intensity, light.vector - P);
  for (const LightOf<float>& light : scene.directional_lights) add(light.intensity, light.vector);
  return i;
}

/// The slides' hit, the light with the approximate 1/√x.
inline void render_rsqrt(const SceneOf<float>& scene, Canvas<float>& out) {
  for_each_pixel(out, [&](int column, int row) -> Seen<float> {
    const Vec<float> D = canvas_to_viewport(scene, column, row);
    const auto [t, i] = closest_sphere(scene.O, D, scene);
    if (i < 0) return {};
    const Vec<float> P = scene.O + t * D;
    Vec<float> N = P - scene.spheres[static_cast<std::size_t>(i)].center;
    N = N / length(N);
    return {i + 1, approximate_lighting(P, N, scene)};
  });
}
#endif

}  // namespace fos::numerics
