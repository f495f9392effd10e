// What the page in the browser is told of a check. It is opened from the file system, where a page
// may load scripts but not data: so everything comes as scripts that call a function of the page.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "examine.hpp"

namespace fos {

/// One check.
struct View {
  const Stage* stage = nullptr;
  std::string id;                       ///< new for each check
  const Findings* findings = nullptr;   ///< nothing where the stage does not compile
  std::string compiler;                 ///< what the compiler said then
  std::string advice;                   ///< the named mistake, or where the chain goes wrong
  std::array<std::string, 3> pictures;  ///< yours, expected, difference, each a PNG; or empty
  Difference difference;                ///< between the frame shown and the exact one
  std::vector<int> parts;               ///< which values_scripts() there are
  std::string scene_file;               ///< that `./lab explain` needs; empty for the lecture's
};

/// `fosView({…});`
std::string view_script(const View& view);

/// The channels before rounding, where a pixel is wrong: `fosValues({…});`, for some rows of the
/// frame, so that none is large; only those with a wrong pixel in them. `data` holds, in base64 and
/// little-endian, for each wrong pixel its index in the frame (32 bits), and its three channels in
/// yours and in the expected frame (six floats).
struct ValuesPart {
  int number;  ///< the rows from number * rows_of_part(width) on
  std::string script;
};
std::vector<ValuesPart> values_scripts(const Shown& shown, const std::string& id);

/// How many rows are in a part.
int rows_of_part(int width);

/// `fosNow("ID", "STAGE");`: the newest check, small enough to be loaded again and again.
std::string now_script(const std::string& id, const Stage& stage);

}  // namespace fos
