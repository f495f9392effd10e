// The slides' formulas word for word, for any number type, on the numbers as written: nothing is
// refused, rescaled or rearranged. What breaks here is what the formulas themselves do.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "fos/nearest.hpp"
#include "fos/scene_text.hpp"

namespace fos::numerics {

template <class T>
using Vec = glm::vec<3, T>;

template <class T>
struct SphereOf {
  Vec<T> center;
  T radius;
};

/// A point light's position, or the L of a directional one.
template <class T>
struct LightOf {
  T intensity;
  Vec<T> vector;
};

/// A scene rounded to T, lights apart by kind, without colors.
template <class T>
struct SceneOf {
  int width = 0;
  int height = 0;
  T viewport_width = 1;
  T viewport_height = 1;
  T projection_plane_d = 1;
  Vec<T> O{0};
  std::vector<SphereOf<T>> spheres;
  T ambient_intensity = 0;
  std::vector<LightOf<T>> point_lights;
  std::vector<LightOf<T>> directional_lights;
};

template <class T>
SceneOf<T> rounded(const SceneText& text) {
  SceneOf<T> scene;
  scene.width = text.canvas_width;
  scene.height = text.canvas_height;
  scene.viewport_width = nearest<T>(text.viewport_size[0]);
  scene.viewport_height = nearest<T>(text.viewport_size[1]);
  scene.projection_plane_d = nearest<T>(text.projection_plane_d);
  scene.O = nearest<T>(text.camera_position);
  for (const SphereText& sphere : text.spheres) {
    scene.spheres.push_back({nearest<T>(sphere.center), nearest<T>(sphere.radius)});
  }
  for (const LightText& light : text.lights) {
    const T intensity = nearest<T>(light.intensity);
    if (light.kind == LightKind::ambient) {
      scene.ambient_intensity = intensity;
    } else {
      (light.kind == LightKind::point ? scene.point_lights : scene.directional_lights)
          .push_back({intensity, nearest<T>(light.vector)});
    }
  }
  return scene;
}

/// What a ray sees: a sphere, by its number in the file from 1, with the light there; or the
/// background, 0.
template <class T>
struct Seen {
  int sphere = 0;
  T I = 1;
};

/// CanvasToViewport, with the pixel's corner as everywhere in Fos.
template <class T>
Vec<T> canvas_to_viewport(const SceneOf<T>& scene, int column, int row) {
  const T W = static_cast<T>(scene.width);
  const T H = static_cast<T>(scene.height);
  const T x = static_cast<T>(column) - W / 2;
  const T y = H / 2 - 1 - static_cast<T>(row);
  return {x * scene.viewport_width / W, y * scene.viewport_height / H, scene.projection_plane_d};
}

/// IntersectRaySphere.
template <class T>
std::pair<T, T> intersect_ray_sphere(const Vec<T>& O, const Vec<T>& D, const SphereOf<T>& sphere) {
  const Vec<T> CO = O - sphere.center;
  const T a = dot(D, D);
  const T b = 2 * dot(CO, D);
  const T c = dot(CO, CO) - sphere.radius * sphere.radius;
  const T discriminant = b * b - 4 * a * c;
  if (discriminant < 0) {
    return {std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()};
  }
  return {(-b + std::sqrt(discriminant)) / (2 * a), (-b - std::sqrt(discriminant)) / (2 * a)};
}

/// ComputeLighting.
template <class T>
T compute_lighting(const Vec<T>& P, const Vec<T>& N, const SceneOf<T>& scene) {
  T i = scene.ambient_intensity;
  const auto add = [&](T intensity, const Vec<T>& L) {
    const T n_dot_l = dot(N, L);
    if (n_dot_l > 0) i += intensity * n_dot_l / (length(N) * length(L));
  };
  for (const LightOf<T>& light : scene.point_lights) add(light.intensity, light.vector - P);
  for (const LightOf<T>& light : scene.directional_lights) add(light.intensity, light.vector);
  return i;
}

/// TraceRay's search: t and the closest sphere's index, or -1.
template <class T>
std::pair<T, int> closest_sphere(const Vec<T>& O, const Vec<T>& D, const SceneOf<T>& scene) {
  T closest_t = std::numeric_limits<T>::infinity();
  int closest = -1;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const auto [t1, t2] = intersect_ray_sphere(O, D, scene.spheres[i]);
    if (t1 >= 1 && t1 < closest_t) closest_t = t1, closest = static_cast<int>(i);
    if (t2 >= 1 && t2 < closest_t) closest_t = t2, closest = static_cast<int>(i);
  }
  return {closest_t, closest};
}

/// TraceRay.
template <class T>
Seen<T> trace_ray(const Vec<T>& D, const SceneOf<T>& scene) {
  const auto [t, i] = closest_sphere(scene.O, D, scene);
  if (i < 0) return {};
  const Vec<T> P = scene.O + t * D;
  Vec<T> N = P - scene.spheres[static_cast<std::size_t>(i)].center;
  N = N / length(N);
  return {i + 1, compute_lighting(P, N, scene)};
}

}  // namespace fos::numerics
