// The system calls that a program in the box may not make (seccomp).
#pragma once

#include "settings.hpp"

namespace fos::grading::inside {

/// For this process and all that come of it, for ever. Most of the calls on the list fail with
/// EPERM; a call by another architecture's rules ends the process. False with errno set where the
/// kernel does not do it.
bool filter_calls(const Settings& settings);

}  // namespace fos::grading::inside
