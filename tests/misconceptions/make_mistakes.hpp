// Makes the data: runs the tracer that makes mistakes over the diagnostic scenes. What a check
// links has none of it.
#pragma once

#include "fos/stage_list.hpp"
#include "mistake_data.hpp"

namespace fos {

/// Every mistake and pair of mistakes of a stage whose picture is not the right one, nor that of
/// one of the two alone. Those that are a finish have no planes of their own:
/// they follow from the others.
StageMistakes make_mistakes(const Stage& stage);

}  // namespace fos
