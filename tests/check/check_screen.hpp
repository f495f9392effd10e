// All that a check says of one stage, for a terminal: the report, a preview of the pictures, what
// to do next and how to see the pixel worked out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "check_report.hpp"
#include "comparison.hpp"
#include "fos/bitmap.hpp"

namespace fos {

/// What there is room for.
struct Window {
  bool preview = false;  ///< pictures make sense: it is a terminal
  int columns = terminal_width;
  int rows = 0;  ///< 0 for any number
};

/// The panels of the picture that goes with a check that does not pass; none where it passes or no
/// frame came. `differs` is of the frame that is shown.
std::vector<Panel> panels_of(const Findings& findings, const Difference& differs);

/// What differs in the frame that is shown; nothing where it passes or none came.
Difference difference_of(const Findings& findings);

/// The picture's panels are at most about this large; they are what PictureJob calls panel_size.
inline constexpr int check_panel_size = 400;

/// `advice` is what advise() says, if anything; `panels` are those of panels_of(). Where the pixel
/// to look at is in a scene that is no file yet, this writes it as STAGE-check.scene into `images`.
/// The preview is left out where there is no room for it.
std::string check_screen(const Findings& findings, const std::string& advice,
                         const std::vector<Panel>& panels, const std::filesystem::path& images,
                         const Paint& paint, const Window& window);

/// The same for a stage that does not compile. `compiler` is what the compiler said, ready to
/// print.
std::string check_screen(const Stage& stage, const std::string& compiler, const Paint& paint);

/// STAGE-check.png in `images`, and where to find it in words.
std::filesystem::path picture_path(const Stage& stage, const std::filesystem::path& images);
std::string picture_line(const std::filesystem::path& path);

/// A path as one word for a shell, and as short as can be from here.
std::string quoted(const std::filesystem::path& path);

}  // namespace fos
