// Why a stage does not compile: the first error, at the student's own line, with a word on the
// commonest mistakes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace fos {

struct CompileError {
  int line = 0;         ///< of the student's file, from 1; 0 where the error is the linker's
  int column = 0;       ///< in characters, from 1; 0 where there is none
  std::string message;  ///< the compiler's, made readable
  std::string source;   ///< the line itself; empty where the file cannot be read
  std::string word;     ///< what to do about it; empty for what is not common
};

/// The first error in `file` or reached from it: in a header that it includes, in a template that
/// it uses. `output` may hold other files' errors, warnings, and ninja's lines, in English; paths
/// in it are absolute or relative. An error of the linker counts where there is none of the
/// compiler. Nothing where no error has to do with the file.
std::optional<CompileError> find_compile_error(std::string_view output,
                                               const std::filesystem::path& file);

/// The same, ready to print: at most about 8 lines of 80 columns. `name` is how the file is called.
/// Where nothing is found, the end of the output.
std::string describe_compile_error(std::string_view output, const std::filesystem::path& file,
                                   std::string_view name);

}  // namespace fos
