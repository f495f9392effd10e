// The second step of reading a scene: the exact decimals become Reals, or are refused.
#pragma once

#include "fos/render.hpp"
#include "fos/scene.hpp"
#include "fos/scene_text.hpp"

namespace fos {

struct SceneFile {
  Scene scene;
  View view;
};

/// Each number rounded to the nearest Real; directions first rescaled by a power of two so that
/// their largest component lies in [1/2, 1), which changes nothing else.
///
/// Throws SceneError, with the number, the limit and what to write instead, for a scene that Real
/// cannot carry through the slides' formulas. With S the distance of a sphere plus its radius r,
/// D the longest ray, d the projection plane, ε and min and max the type's:
///   b², 4ac, c, |N|² and t stay finite  2 (2 S max(1, |D|))² <= max
///   a, r² and 4 a r² keep their digits  d², r², 4 d² r² >= min / ε
///   P is never the centre, so |N| > 0  r >= 4 √ε |OC|,  r >= 16 ε (|O| + |C|)
///   |L|² stays finite                  4 (|position| + farthest P)² <= max
///   |L|² is 0 only when L is           (ε g / 2)² >= min, g the smallest number but 0 among the
///                                      coordinates of camera and lights and the steps of the
///                                      canvas
///   I ⟨N,L⟩ and color × I stay finite  2 I max(1, r) |L| <= max,  1024 ΣI <= max
/// They hold for N normalised or not; beside the code in scene_file.cpp is why. How far beyond its
/// limit each really breaks is in tests/numerics/limits_test.cpp: 3 to 16 times for most that
/// overflow, far more for what only begins to lose digits there.
/// None of them asks for accuracy: where a sphere is nearly refused as too far, 700 radii away in
/// float and 1.6e7 in double, b² − 4ac is wrong by up to 0.12 and 0.05 of I, and has a quarter of
/// the bytes wrong. closest_hit errs by 3e-5 and 1e-9; but stages of lecture 3 are without it.
SceneFile to_scene(const SceneText& text);

}  // namespace fos
