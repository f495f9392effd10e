// The child that becomes the program: its limits, its fences, its own user, then exec.
#pragma once

#include <cstdint>

#include "settings.hpp"

namespace fos::grading::inside {

/// Where it failed.
enum class Step : std::uint32_t {
  fork = 1,
  session,
  user,
  folder,
  limits,
  privileges,
  landlock,
  filter,
  exec
};

struct Failure {
  Step step;
  int error;  ///< errno
};

/// Does not return: it execs, or writes a Failure to `errors` (which exec closes) and ends.
[[noreturn]] void become_program(const Settings& settings, int errors);

}  // namespace fos::grading::inside
