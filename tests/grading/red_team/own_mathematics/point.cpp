// tries: replaces functions of the libraries, in the hope that the comparison uses them
// deserves: point nothing
#include <cstdlib>
#include <cstring>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

extern "C" {
double fabs(double) noexcept { return 0; }
int memcmp(const void*, const void*, std::size_t) noexcept { return 0; }
int strcmp(const char*, const char*) noexcept { return 0; }
}

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
