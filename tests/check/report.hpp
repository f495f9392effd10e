// A verdict in words.
#pragma once

#include <string>
#include <string_view>

#include "fos/stage_program.hpp"
#include "judge.hpp"
#include "stage_test.hpp"

namespace fos {

/// What is wrong with a frame (or, for one that passes, worth a note), line by line, non-finite
/// pixels first: how many, which is the first, what was expected there and what came. Empty for a
/// frame that is right in every way.
std::string describe(const Judge& judge, const Frame& frame, const Verdict& verdict,
                     std::string_view scene_name);

/// A pixel of a frame that is not what was worked out by hand: where, what is expected, what came.
std::string describe(const PixelCase& expected, const Frame& frame);

/// Why there is no frame to judge, and at which pixel it ended.
std::string describe(const Answer& answer, std::string_view scene_name);

}  // namespace fos
