// tries: never comes to an end
// deserves: point nothing
#include <csignal>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) {
  std::signal(SIGXCPU, SIG_IGN);
  for (volatile bool for_ever = true; for_ever;) {
  }
  return Color(0);
}

}  // namespace fos
