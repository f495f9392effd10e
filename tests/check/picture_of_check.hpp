// The comparison as a file.
#pragma once

#include <filesystem>
#include <vector>

#include "fos/bitmap.hpp"

namespace fos {

/// Writes the panels side by side as a PNG, through `picture_program`, which is fos_picture: it
/// alone loads OpenImageIO, and only here, so that a check that passes never waits for that.
/// Returns whether it could; what stood in the way is on standard error.
bool write_picture(const std::filesystem::path& picture_program, const std::filesystem::path& path,
                   const std::vector<Panel>& panels);

}  // namespace fos
