// tries: prints without an end
// deserves: point nothing
#include <cstdio>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) {
  for (;;) std::puts("all is well all is well all is well all is well all is well all is well");
}

}  // namespace fos
