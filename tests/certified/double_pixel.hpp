// One pixel of a certified picture in doubles with running error bounds: the slides' formulas, any
// number of spheres of any kind. Nothing where the bounds do not decide.
#pragma once

#include <optional>
#include <span>

#include "camera_scene.hpp"

namespace fos::certified {

/// The bytes of the pixel at x, y (pixels from the middle). `candidates` are all spheres that may
/// be seen there.
std::optional<Bytes> double_pixel(const CameraScene& scene,
                                  std::span<const CameraSphere* const> candidates, double x,
                                  double y);

}  // namespace fos::certified
