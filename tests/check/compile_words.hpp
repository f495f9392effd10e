// A word on the commonest mistakes that keep a stage from compiling.
#pragma once

#include <string>
#include <vector>

#include "compiler_output.hpp"

namespace fos {

/// What is known about an error when words for it are looked for.
struct CompileContext {
  std::string message;             ///< cleaned
  std::vector<std::string> notes;  ///< cleaned
  std::vector<std::string> lines;  ///< the student's file; empty where it cannot be read
  int line = 0;                    ///< of the error in it, from 1; 0 where it is the linker's

  /// The error's line; empty where there is none.
  std::string source() const {
    const auto number = static_cast<std::size_t>(line);
    return number >= 1 && number <= lines.size() ? lines[number - 1] : "";
  }
};

/// What a beginner should do about it, in this process's language; empty for an error that is none
/// of the common ones.
std::string compile_word(const CompileContext& context);

}  // namespace fos
