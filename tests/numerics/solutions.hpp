// The solution of `combined` at each precision: the real program, asked as any stage is.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "extremes_errors.hpp"

namespace fos::numerics {

/// Each pixel; or, in words, why the program does not take the scene. Throws std::runtime_error
/// where the program is not there or does something else.
///
/// I is found by dividing by the color of the sphere, which is told by its color: spheres need
/// colors of which none is a multiple of another, and none is the background's.
std::variant<std::vector<Said>, std::string> ask_solution(Precision precision,
                                                          const SceneText& scene,
                                                          const Truth& truth);

}  // namespace fos::numerics
