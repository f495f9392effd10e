// `./lab explain`: the pixel's chain in words, yours beside the right one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "finding.hpp"

namespace fos {

/// What is asked about.
struct Subject {
  const SceneText& scene;
  const Stage& stage;
  int column = 0;  ///< on the scene's canvas
  int row = 0;
};

struct Explanation {
  std::string text;   ///< for standard output
  std::string words;  ///< what the program said on standard error
  /// 0 yours is right, or there is no program; 1 it is not, or gave no answer; 2 it does not
  /// bear the scene; 3 it does not start.
  int status = 0;
};

/// Lines of 80 columns at most, up to the first that differs; then a drawing and what can be
/// said of it. Without a program, what is right alone. Throws std::range_error for numbers
/// beyond 10^±10000, reference::UndecidedError.
Explanation explain(const Subject& subject, const std::optional<std::filesystem::path>& program,
                    bool colors);

}  // namespace fos
