// tries: takes all the memory there is
// deserves: point nothing
#include <cstdlib>
#include <cstring>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) {
  for (;;) {
    if (void* memory = std::malloc(1 << 24)) std::memset(memory, 1, 1 << 24);
  }
}

}  // namespace fos
