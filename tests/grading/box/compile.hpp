// A stage that a student handed in, made into a program; in the box.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "fos/stage_program.hpp"
#include "grading/box/run.hpp"
#include "grading/box/workshop.hpp"

namespace fos::grading {

enum class CompileEnding {
  compiled,
  rejected,        ///< the compiler or the linker says no
  over_limit,      ///< it took too much time, memory or disk: `run` says which
  infrastructure,  ///< the box did not start the compiler, or lost it
};

struct CompileJob {
  std::filesystem::path source;  ///< the student's file
  std::string name;              ///< as messages call it: labs/lecture04/point.cpp
  int lecture = 4;               ///< whose headers it sees
  bool sanitized = false;        ///< with sanitizers and debug information, to say where it crashes
  std::filesystem::path program;  ///< where to put it; run it in a box of the same slot
};

struct CompileResult {
  CompileEnding ending = CompileEnding::infrastructure;
  std::string output;  ///< the compiler's warnings and errors, at most 64 KiB
  RunResult run;       ///< without its output
};

/// Compiles and links. What the compiler warns of is kept, and does not count. Throws
/// std::filesystem::filesystem_error where the disk is in the way.
CompileResult compile(
    const Workshop& workshop, const Box& box, unsigned slot, const CompileJob& job,
    const std::function<void()>& on_wait = [] {});

/// The words that ask the compiled program in its box, for StageProgram.
SupervisedCommand stage_command(const Box& box, const std::filesystem::path& program,
                                const BoxLimits& limits, bool sanitized = false);

}  // namespace fos::grading
