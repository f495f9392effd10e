// tries: includes the solution, where the compiler can see it
// deserves: point nothing
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

#if __has_include("../../solutions/lecture04/point.cpp")
#include "../../solutions/lecture04/point.cpp"
#elif __has_include("/autograder/source/solutions/lecture04/point.cpp")
#include "/autograder/source/solutions/lecture04/point.cpp"
#else
namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
#endif
