// The scenes that the stages are checked with, for tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fos/scene_text.hpp"

namespace fos {

inline SceneText lecture_scene() {
  return read_scene_text(std::filesystem::path(FOS_LAB_SCENES) / "lecture.scene");
}

inline SceneText test_scene(const std::string& name) {
  return read_scene_text(std::filesystem::path(FOS_TEST_SCENES) / (name + ".scene"));
}

/// All of them; of the lecture's, which is large, the test may skip pixels.
inline std::vector<SceneText> all_scenes() {
  std::vector<SceneText> scenes{lecture_scene()};
  for (const auto& entry : std::filesystem::directory_iterator(FOS_TEST_SCENES)) {
    scenes.push_back(read_scene_text(entry.path()));
  }
  return scenes;
}

/// Calls `look(column, row)` for some thousand pixels of a scene, in every part of the
/// canvas.
template <class Look>
void for_some_pixels(const SceneText& scene, int about, const Look& look) {
  const int pixels = scene.canvas_width * scene.canvas_height;
  int step = pixels / about + 1;
  while (scene.canvas_width % step == 0 && step > 1) ++step;  // not always the same columns
  for (int i = 0; i < pixels; i += step) look(i % scene.canvas_width, i / scene.canvas_width);
}

}  // namespace fos
