// tries: closes all descriptors before main begins
// deserves: point nothing
#include <unistd.h>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace {
const bool started = [] {
  for (int descriptor = 0; descriptor < 1024; ++descriptor) close(descriptor);
  return true;
}();
}  // namespace

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
