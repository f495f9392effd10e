// Scenes that are made of another: with some of its lights only, on a canvas for one ray.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "fos/scene_text.hpp"

namespace fos {

/// A scene file that reads as `scene`, every number as it was written.
std::string source_of(const SceneText& scene);

/// The scene with these of its lights (indices, rising) and no others; its source too.
SceneText with_lights(const SceneText& scene, std::span<const std::size_t> lights);

/// A scene on a canvas of at most 4 x 4 pixels, one of which sees what a pixel of another
/// saw.
struct OneRay {
  SceneText scene;
  int column = 0;
  int row = 0;
};

/// The scene with a canvas and a viewport such that one pixel has the D of (column, row) in
/// `scene`: the very same doubles. Few other rays are computed with it: what matters is one
/// pixel, and a large picture would be made only to be thrown away.
OneRay one_ray(const SceneText& scene, int column, int row);

}  // namespace fos
