// What a program may answer at one pixel, by the same rule as for whole frames (judge.hpp):
// for a scene, and for the same scene with some of its lights only.
#pragma once

#include <span>

#include "exact_hit.hpp"
#include "judge.hpp"
#include "rounded_scene.hpp"

namespace fos {

class RightAnswers {
 public:
  /// Throws std::range_error for numbers beyond 10^±10000.
  RightAnswers(const SceneText& scene, int column, int row);

  /// A judge of frames of 1 x 1 pixel: this pixel, in the scene with these lights (indices in
  /// SceneText::lights, rising) and no others. `terms` as in Stage. Throws
  /// reference::UndecidedError.
  Judge judge(std::span<const std::size_t> lights, unsigned terms) const;

 private:
  SceneText scene_;
  reference::ExactScene exact_;  ///< on a canvas whose only pixel has the same D
  std::optional<reference::ExactHit> hit_;
  std::array<reference::Possible, reference::precisions.size()> possible_;
};

}  // namespace fos
