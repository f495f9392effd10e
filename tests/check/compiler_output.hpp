// What a compiler or linker printed, as data: g++'s, clang++'s, ninja's lines in between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fos {

/// A place in a file, as a compiler names it.
struct SourcePlace {
  std::string file;  ///< absolute, or relative to the build folder
  int line = 0;      ///< from 1
  int column = 0;    ///< from 1, 0 where none is given; see CompilerOutput::columns_are_bytes
};

/// A place that led to an error elsewhere, or says more about it.
struct Related {
  enum class Kind {
    included,   ///< `In file included from`
    requested,  ///< a template was used there: `required from here`, `requested here`
    note        ///< any other note
  };
  Kind kind;
  SourcePlace place;
  std::string message;  ///< of a note
};

struct Diagnostic {
  SourcePlace place;    ///< no file: the linker's
  std::string message;  ///< its first line, as it was printed, without `error: `
  std::vector<Related> related;
};

struct CompilerOutput {
  std::vector<Diagnostic> errors;  ///< in the order printed; warnings are left out
  /// clang++ counts bytes; g++ columns of a terminal, where a tab goes on to the next eighth.
  bool columns_are_bytes = false;
};

/// Reads messages in English: run the compiler with LC_ALL=C.UTF-8.
CompilerOutput read_compiler_output(std::string_view output);

}  // namespace fos
