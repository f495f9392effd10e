// tries: reads what it is asked before the toolkit does
// deserves: point nothing
#include <unistd.h>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace {
const bool started = [] {
  char bytes[65536];
  [[maybe_unused]] const ssize_t count = read(0, bytes, sizeof(bytes));
  return true;
}();
}  // namespace

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
