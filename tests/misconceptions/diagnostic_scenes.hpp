// The small scenes on which mistakes are told apart, and what is made of them.
#pragma once

#include <cstddef>
#include <vector>

#include "fos/scene_text.hpp"
#include "fos/stage_list.hpp"

namespace fos {

/// The scenes of tests/misconceptions/scenes, in the order of the data.
const std::vector<SceneText>& base_scenes();

/// How many pixels a scene's own canvas has.
std::size_t pixels_of(const SceneText& scene);

/// What to ask a stage program for, so that diagnose() can look at its frames: the base scenes; for
/// a stage with lights of both kinds then the same without the directional lights, without the
/// point lights, and without either, since I is a sum.
std::vector<SceneText> diagnostic_scenes(const Stage& stage);

/// A base scene with one of the lights that the stage counts, and no other, not even the ambient
/// one: scene by scene, in the order of the file, the point lights first. For locate().
struct TermScene {
  SceneText scene;
  std::size_t base;  ///< index in base_scenes()
  LightKind kind;
};
std::vector<TermScene> term_scenes(const Stage& stage);

}  // namespace fos
