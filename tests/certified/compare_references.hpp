// The reference by the machine's intervals against the oracle's.
#pragma once

#include "fos/scene_text.hpp"

namespace fos::certified {

enum class ReferenceComparison {
  equal,       ///< field for field
  same_error,  ///< both throw the same type, with the same words
  different
};

ReferenceComparison compare_references(const SceneText& scene);

}  // namespace fos::certified
