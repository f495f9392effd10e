// The whole reference of a scene, equal to that of reference::generate, sooner.
//
// Nearly all pixels are decided by intervals of the machine: what float and double programs may see
// is the oracle's own formula with the same ends, bit for bit; where all that a double may see is
// one hit, the exact one is it; and the terms need few of the 96 bits that the oracle starts with.
// What stays open, or leaves the range of the machine's numbers, goes to the oracle.
#pragma once

#include <atomic>

#include "fos/scene_text.hpp"
#include "generate.hpp"

namespace fos::certified {

/// How many pixels the machine left open.
struct ReferenceEffort {
  std::atomic<long> by_oracle = 0;  ///< certified by the oracle; all others by the machine
  std::atomic<long> with_mpfi = 0;  ///< of these, for which it also made an accepted set
};

/// Throws what reference::generate throws.
reference::Reference reference(const SceneText& scene, ReferenceEffort* effort = nullptr);

}  // namespace fos::certified
