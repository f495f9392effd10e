// The text of scenes with numbers of any size, and what to_scene says of them.
#pragma once

#include <fmt/core.h>

#include <cstdlib>
#include <string>

#include "fos/scene_file.hpp"

namespace fos::numerics {

using Wide = long double;

inline std::string decimal(Wide number) { return fmt::format("{:.22e}", number); }

inline std::string view(Wide d, Wide size) {
  return fmt::format("projection_plane_d = {}\nviewport_size = {} x {}\n", decimal(d),
                     decimal(size), decimal(size));
}

/// Why Real cannot carry a scene, or "".
inline std::string refusal(const SceneText& text) {
  setenv("FOS_LANG", "en", 1);
  try {
    to_scene(text);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

}  // namespace fos::numerics
