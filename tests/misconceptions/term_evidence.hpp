// What the frames with one light at a time show: where it reaches, and how strong it is there.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "diagnostic_scenes.hpp"
#include "explanation.hpp"
#include "fos/frame.hpp"
#include "strength.hpp"

namespace fos {

/// Pixels of all the frames with a light of one kind.
struct TermEvidence {
  std::size_t behind = 0;          ///< the light is behind the surface
  std::size_t from_behind = 0;     ///< and yet they are lit
  std::size_t reached = 0;         ///< it is in front
  std::size_t dark = 0;            ///< and yet they are dark
  bool strength_is_wrong = false;  ///< somewhere it is in front, and another I comes back
  std::vector<Lit> lit;
};

/// `term_frames` are those of term_scenes(stage); those that are empty are left out.
TermEvidence look_at_terms(const Stage& stage, LightKind kind, const Explainer& explainer,
                           std::span<const Frame> term_frames);

}  // namespace fos
