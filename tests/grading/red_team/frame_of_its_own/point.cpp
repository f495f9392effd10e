// tries: sends a frame before it is asked, as large as the published scene, and leaves
// deserves: point nothing
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace {
const bool started = [] {
  struct {
    char magic[8];
    std::int32_t width, height;
    std::uint32_t precision, rest;
  } header{"fos", 600, 600, 1, 0};
  [[maybe_unused]] ssize_t sent = write(3, &header, sizeof(header));
  const std::vector<double> white(600 * 3, 255.0);
  const std::vector<char> flags(600);
  for (int row = 0; row < 600; ++row) {
    sent = write(3, white.data(), white.size() * sizeof(double));
    sent = write(3, flags.data(), flags.size());
  }
  _exit(0);
  return true;
}();
}  // namespace

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { return Color(0); }

}  // namespace fos
