// An errand from its start to its end.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grading/box/box.hpp"

namespace fos::grading {

enum class RunEnding {
  exited,          ///< by itself: `status`
  signalled,       ///< by the signal `status`
  out_of_time,     ///< its processor time is spent, it was idle, or the clock ran out
  out_of_memory,   ///< all its processes together
  flooded,         ///< it printed more than it may
  over_limit,      ///< too many processes, or too much written to files
  infrastructure,  ///< the box did not start it, or was lost: `status` is an errno or 0
};

struct RunResult {
  RunEnding ending = RunEnding::infrastructure;
  int status = 0;
  unsigned step = 0;   ///< infrastructure: where it failed, an inside::Step; 0 if it is not known
  std::string output;  ///< standard output and error together, up to the cap; for infrastructure,
                       ///< what the box said
  double cpu_seconds = 0;         ///< of all its processes
  std::uint64_t peak_memory = 0;  ///< bytes

  bool succeeded() const { return ending == RunEnding::exited && status == 0; }
};

struct RunLimits {
  std::size_t output = 65536;                                 ///< bytes; what prints more is ended
  bool cut = false;                                           ///< it is not: the rest is dropped
  std::chrono::milliseconds wall = std::chrono::minutes(10);  ///< for what escapes all else
};

/// Does the errand; afterwards nothing of it is alive. `on_wait` is called a few times a second;
/// what it throws passes through, after the errand has been ended.
RunResult run(
    const Box& box, const Errand& errand, const RunLimits& limits = {},
    const std::function<void()>& on_wait = [] {});

}  // namespace fos::grading
