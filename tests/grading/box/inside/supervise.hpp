// The supervisor of one program in the box: process 1 of its namespace where there is one. It
// starts the program, watches what it uses, ends it, and says how it ended (fos/supervision.hpp).
#pragma once

#include "settings.hpp"

namespace fos::grading::inside {

/// Until the program has ended, or the asker is gone; then nothing of it is left.
void supervise(const Settings& settings);

}  // namespace fos::grading::inside
