// A stage's program, built as `./lab` builds it.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "fos/stage_list.hpp"

namespace fos {

struct Built {
  bool is_built = false;
  std::string words;  ///< what the compiler said, where it is not
};

/// Has ninja bring lab_STAGE up to date, when no other `./lab` is building. `anew`: the file has
/// changed since its last build, whatever its time says; where times are in whole seconds ninja
/// would miss it.
Built build_stage(const std::filesystem::path& root, const std::filesystem::path& build,
                  const Stage& stage, bool anew, const std::stop_token& stop);

/// What the compiler said, without what ninja and CMake say around it, and with paths from `root`.
std::string compiler_words(const std::string& log, const std::filesystem::path& root);

}  // namespace fos
