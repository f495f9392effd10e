// libFuzzer: any bytes are a scene or a SceneError, never a crash; and in a scene the slides'
// formulas and closest_hit stay finite.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "fos/closest_hit.hpp"
#include "slides.hpp"

namespace fos {

// render.cpp wants a stage; none is run.
Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view source(reinterpret_cast<const char*>(data), size);
  try {
    fos::SceneFile file = fos::to_scene(fos::parse_scene_text(source, "fuzz"));
    file.view.canvas_width = std::min(file.view.canvas_width, 3);
    file.view.canvas_height = std::min(file.view.canvas_height, 3);
    const fos::Vec3 D = fos::canvas_to_viewport(file.view, 0, 0);
    const auto hit = fos::closest_hit(file.view.camera_position, D, 1, fos::infinity, file.scene);
    if ((hit && !std::isfinite(hit->t)) || !fos::slides_stay_finite(file)) std::abort();
  } catch (const fos::SceneError& error) {
    if (std::string_view(error.what()).find(": ") == std::string_view::npos) std::abort();
  }
  return 0;
}
