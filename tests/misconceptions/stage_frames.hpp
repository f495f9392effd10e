// What the tests ask of the tracer that makes mistakes, as if it were a stage program.
#pragma once

#include <vector>

#include "diagnostic_scenes.hpp"
#include "scene_at.hpp"

namespace fos {

/// The frames that diagnose() takes.
template <typename T>
std::vector<Frame> mistaken_frames(const Stage& stage, const MistakeSet& mistakes) {
  std::vector<Frame> frames;
  for (const SceneText& scene : diagnostic_scenes(stage)) {
    frames.push_back(mistaken_frame(SceneAt<T>(scene), stage.terms, mistakes));
  }
  return frames;
}

}  // namespace fos
