// libFuzzer: any bytes are a scene or a SceneError, never a crash; and of a scene, what the stages
// are promised holds.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "fos/closest_hit.hpp"
#include "fos/scene_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view source(reinterpret_cast<const char*>(data), size);
  try {
    const fos::SceneFile file = fos::to_scene(fos::parse_scene_text(source, "fuzz"));
    for (const auto& [column, row] : {std::pair{0, 0}, {file.view.canvas_width / 2, 0}}) {
      const fos::Vec3 D = fos::canvas_to_viewport(file.view, column, row);
      const auto hit = fos::closest_hit(file.view.camera_position, D, 1, fos::infinity, file.scene);
      if (hit && !std::isfinite(hit->t)) std::abort();
    }
  } catch (const fos::SceneError& error) {
    if (std::string_view(error.what()).find(": ") == std::string_view::npos) std::abort();
  }
  return 0;
}
