// tries: has a main of its own, which says that all is well
// deserves: point nothing
#include <cstdio>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

int main() {
  std::puts("100%");
  return 0;
}

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
