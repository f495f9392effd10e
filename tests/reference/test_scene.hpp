// Scenes for tests, from a few lines.
#pragma once

#include <string>

#include "exact_scene.hpp"
#include "fos/scene_text.hpp"

namespace fos::reference {

/// A scene of 2 x 2 pixels, of which (column 1, row 0) looks along (0, 0, 1) from the origin.
inline SceneText small_scene(const std::string& lines) {
  return parse_scene_text("canvas_size = 2 x 2\n" + lines, "test");
}

inline ExactScene small_exact_scene(const std::string& lines) {
  return to_exact(small_scene(lines));
}

inline const Triple<mpq_class> ahead{0, 0, 1};

}  // namespace fos::reference
