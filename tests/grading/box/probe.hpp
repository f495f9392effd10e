// Which box this machine can have: tried, not guessed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grading/box/box.hpp"

namespace fos::grading {

/// Why a level cannot be had here.
struct NotHad {
  Level level;
  std::string why;  ///< ready to show
};

struct ProbeResult {
  std::optional<Level> level;   ///< the strongest that works; nothing where none does
  std::vector<NotHad> not_had;  ///< each stronger one
};

struct ProbeSetting {
  BoxSetting box;                 ///< its `level` is not looked at
  std::filesystem::path scratch;  ///< a folder for trials, where the box's user can come
  /// What no program in the box may read: references, solutions, submissions, results.
  std::vector<std::filesystem::path> secrets;
  std::optional<Level> only;  ///< this level or nothing
  bool unsafe = false;        ///< take Level::none if there is nothing better
};

/// Runs a trial in each level, from the strongest, until one holds: it starts, and can neither read
/// a secret, nor write outside, nor reach other processes or the network. Level::none is taken only
/// if `unsafe` says so.
ProbeResult probe(const ProbeSetting& setting);

}  // namespace fos::grading
