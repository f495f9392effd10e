// The whole reference of a scene.
#pragma once

#include <functional>

#include "exact_scene.hpp"
#include "fos/scene_text.hpp"
#include "oracle.hpp"
#include "reference_file.hpp"

namespace fos::reference {

/// The first step to try for a scene's terms: 2^-40 of the brighter kind of light, 2^-40 without
/// light. Throws std::range_error if a double does not carry such terms.
int coarsest_step(const ExactScene& scene);

/// What tells the truth about each pixel, from two threads at once: an Oracle, or something that
/// says the same sooner.
using PixelSource = std::function<PixelTruth(int column, int row)>;
/// Makes one for terms that are multiples of 2^step.
using MakePixelSource = std::function<PixelSource(const ExactScene& scene, int step)>;

/// Certifies all pixels, in two threads. If the step is too coarse for one of them, starts again
/// with a finer one. Throws UndecidedError, StepError (oracle.hpp) and std::range_error.
Reference generate(const SceneText& text);
Reference generate(const SceneText& text, const MakePixelSource& make_source);

}  // namespace fos::reference
