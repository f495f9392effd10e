// What the mistakes of a diagnosis make of any scene.
#pragma once

#include "diagnosis.hpp"
#include "fos/frame.hpp"
#include "fos/scene_text.hpp"

namespace fos::grading {

class MistakenAnswers {
 public:
  /// `diagnosis` names its mistakes for certain: one_of is empty.
  MistakenAnswers(const Stage& stage, const Diagnosis& diagnosis);

  /// Whether the frame is what a program with these mistakes gives, but for a few pixels: at the
  /// rim of a sphere a rounding decides, and nothing has been certified for wrong programs.
  bool gives(const SceneText& scene, const Frame& frame) const;

 private:
  Frame frame_of(const SceneText& text) const;

  const Stage* stage_;
  MistakeSet everywhere_;
  MistakeSet point_;        ///< for the point lights' term only
  MistakeSet directional_;  ///< likewise
};

}  // namespace fos::grading
