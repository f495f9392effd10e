// The real solution of `combined`, through the real render loop, as a row of its own.
#pragma once

#include "rung.hpp"

namespace fos::numerics {

/// Throws SceneError for a scene that double cannot carry.
Rung solution_rung(const SceneText& scene);

}  // namespace fos::numerics
