// What the resident picture program, `fos_picture serve`, is asked on its standard input: a picture
// to make. It answers each job, in order, by a line: `made`, or what stood in the way.
#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fos/bitmap.hpp"

namespace fos {

/// A PNG to be made of panels side by side.
struct PictureJob {
  std::filesystem::path path;
  std::vector<Panel> panels;
  int panel_size = 0;  ///< of the square that each is fitted in, its label below; 0 for a single
                       ///< panel whose pixels are to be kept as they are, without a label
};

/// The answer to a job that is done.
inline constexpr std::string_view picture_made = "made";

/// A line `picture PANEL_SIZE PANELS PATH_BYTES`, the path, then the panels.
std::string encode(const PictureJob& job);

/// The next job; nothing at the end of the input. Throws std::runtime_error where there is
/// something else.
std::optional<PictureJob> read_picture_job(std::istream& in);

}  // namespace fos
