// tries: is black, which is its own mirror image and as bright as its double
// deserves: point nothing
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
