// A certified picture against the interval tracer's own bytes, pixel by pixel.
#pragma once

#include <string>

#include "certified.hpp"

namespace fos::certified {

struct Comparison {
  Effort effort;
  long wrong_bytes = 0;      ///< that differ from the interval tracer's
  long broken_claims = 0;    ///< pixels whose I is farther off than the floats claim
  double closest_claim = 0;  ///< the largest part of its bound that an error of I reached
  std::string first;         ///< the first difference, in words

  bool is_sound() const { return wrong_bytes + broken_claims == 0; }
};

/// By the scene's own plan, or by the general one.
Comparison compare(const SceneText& scene, reference::Terms terms, bool by_general_plan = false);

}  // namespace fos::certified
