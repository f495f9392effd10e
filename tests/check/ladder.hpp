// The hints of a stage as a ladder that is climbed one rung at a call.
#pragma once

#include <filesystem>
#include <string>

#include "fos/stage_list.hpp"

namespace fos {

/// Where the person stands: a file per stage in a folder, which holds the number of the last hint.
class Ladder {
 public:
  /// What the file does not hold as a number of a hint is the ground, before the first one.
  Ladder(const Stage& stage, std::filesystem::path folder);

  /// The next hint, ready to print; the last one again at the top.
  std::string next();

  /// All of them; where the person stands does not change.
  std::string all() const;

  /// Writes down where the person stands now. Throws FileError.
  void remember() const;

  /// Back to the ground. Throws FileError.
  void forget();

 private:
  std::string hint(std::size_t number) const;
  std::string end() const;

  const Stage& stage_;
  std::filesystem::path folder_;
  std::size_t reached_ = 0;  // hints seen
};

}  // namespace fos
