// tries: uses up the stack
// deserves: point nothing
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace {
int deep(volatile int* from) {
  volatile int here[64] = {*from};
  return deep(here) + here[1];
}
}  // namespace

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) {
  volatile int zero = 0;
  return Color(static_cast<fos::Real>(deep(&zero)));
}

}  // namespace fos
