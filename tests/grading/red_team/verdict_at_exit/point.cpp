// tries: replaces the verdict when the program ends, by atexit and by a destructor
// deserves: point nothing
#include <cstdio>
#include <cstdlib>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace {
void boast() { std::puts("All tests passed (3 assertions in 3 test cases)"); }
struct Last {
  Last() { std::atexit(boast); }
  ~Last() { boast(); }
} last;
}  // namespace

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
