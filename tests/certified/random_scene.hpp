// Scenes that nobody chose, to find what a proof has overlooked: ordinary ones, and all kinds of
// extremes. The same seed gives the same scene on every machine.
#pragma once

#include <cstdint>
#include <string>

namespace fos::certified {

/// The text of a scene file of size x size pixels.
std::string random_scene(std::uint64_t seed, int size);

}  // namespace fos::certified
