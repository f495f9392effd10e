// A verdict in words, and as a picture: yours, expected, and the difference.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "fos/stage_program.hpp"
#include "judge.hpp"

namespace fos {

/// What is wrong with a frame (or, for one that passes, worth a note), line by line, non-finite
/// pixels first: how many, which is the first, what was expected there and what came. Empty for a
/// frame that is right in every way.
std::string describe(const Judge& judge, const Frame& frame, const Verdict& verdict,
                     std::string_view scene_name);

/// Why there is no frame to judge.
std::string describe(const Answer& answer, std::string_view scene_name);

/// Writes yours / expected / difference side by side. `picture_program` is fos_picture: it alone
/// loads OpenImageIO, and only here, so that a check that passes never waits for that. Returns
/// whether it could.
bool write_comparison(const std::filesystem::path& picture_program,
                      const std::filesystem::path& path, const Judge& judge, const Frame& frame);

}  // namespace fos
