// A scene at any number type, for the tracer that makes mistakes.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "fos/frame.hpp"
#include "fos/nearest.hpp"
#include "mistaken_tracer.hpp"

namespace fos {

/// The members that the tracer needs of fos::Scene, and the camera.
template <typename T>
struct SceneAt {
  using Vec = glm::vec<3, T>;
  struct Sphere {
    Vec center;
    T radius;
    Vec color;
  };
  struct PointLight {
    T intensity;
    Vec position;
  };
  struct DirectionalLight {
    T intensity;
    Vec direction;
  };

  Vec background_color;
  std::vector<Sphere> spheres;
  T ambient_intensity = 0;
  std::vector<PointLight> point_lights;
  std::vector<DirectionalLight> directional_lights;

  int width;
  int height;
  T viewport_width;
  T viewport_height;
  T projection_plane_d;
  Vec camera_position;

  explicit SceneAt(const SceneText& text)
      : background_color(nearest<T>(text.background_color)),
        width(text.canvas_width),
        height(text.canvas_height),
        viewport_width(nearest<T>(text.viewport_size[0])),
        viewport_height(nearest<T>(text.viewport_size[1])),
        projection_plane_d(nearest<T>(text.projection_plane_d)),
        camera_position(nearest<T>(text.camera_position)) {
    for (const SphereText& sphere : text.spheres) {
      spheres.push_back(
          {nearest<T>(sphere.center), nearest<T>(sphere.radius), nearest<T>(sphere.color)});
    }
    for (const LightText& light : text.lights) {
      const T intensity = nearest<T>(light.intensity);
      const Vec vector = nearest<T>(light.vector);
      if (light.kind == LightKind::ambient) ambient_intensity = intensity;
      if (light.kind == LightKind::point) point_lights.push_back({intensity, vector});
      if (light.kind == LightKind::directional) {
        directional_lights.push_back({intensity, rescaled(vector)});
      }
    }
  }

  /// D of a pixel, as render.hpp has it.
  Vec direction(int column, int row) const {
    const T x = T(column) - T(width) / 2;
    const T y = T(height) / 2 - 1 - T(row);
    return {x * viewport_width / T(width), y * viewport_height / T(height), projection_plane_d};
  }

 private:
  /// As a stage is given it: the largest component in [1/2, 1).
  static Vec rescaled(const Vec& v) {
    const Vec size = abs(v);
    int exponent = 0;
    static_cast<void>(std::frexp(std::max({size.x, size.y, size.z}), &exponent));
    return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
  }
};

/// What each pixel of a scene sees with these mistakes, row by row from the top.
template <typename T>
auto mistaken_picture(const SceneAt<T>& scene, unsigned terms, const MistakeSet& mistakes) {
  const MistakenTracer<T, SceneAt<T>> tracer(scene, terms, mistakes);
  std::vector<typename MistakenTracer<T, SceneAt<T>>::Seen> pixels;
  pixels.reserve(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height));
  for (int row = 0; row < scene.height; ++row) {
    for (int column = 0; column < scene.width; ++column) {
      pixels.push_back(tracer.trace(scene.camera_position, scene.direction(column, row), 1,
                                    std::numeric_limits<T>::infinity()));
    }
  }
  return pixels;
}

/// The same as a frame, as a stage program of that number type answers.
template <typename T>
Frame mistaken_frame(const SceneAt<T>& scene, unsigned terms, const MistakeSet& mistakes) {
  Frame frame;
  frame.header = {scene.width, scene.height,
                  sizeof(T) == sizeof(float) ? Precision::binary32 : Precision::binary64};
  for (const auto& seen : mistaken_picture(scene, terms, mistakes)) {
    for (int channel = 0; channel < 3; ++channel) {
      frame.channels.push_back(static_cast<long double>(seen.color[channel]));
    }
    frame.unwritten.push_back(0);
  }
  return frame;
}

}  // namespace fos
