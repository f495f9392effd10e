// tries: gives every pixel all there is
// deserves: point nothing
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(255); }

}  // namespace fos
