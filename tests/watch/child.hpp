// Programs that watch starts: the build, heard; a hint or an explanation, in the terminal.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace fos {

/// What a program printed, and how it ended.
struct Heard {
  int status = 127;   ///< as a shell has it: 128 and the number of the signal that ended it
  std::string words;  ///< standard output and error, together
};

/// Runs a program, found by PATH, without a terminal. Asked to stop, it is told to end, and it is
/// gone when this returns.
Heard run_heard(const std::vector<std::string>& command, const std::stop_token& stop);

/// Runs a program in the terminal, which it may use as it likes. Stopped by Ctrl-Z, this process
/// stops with it. Returns its status as a shell has it.
int run_in_terminal(const std::vector<std::string>& command);

}  // namespace fos
