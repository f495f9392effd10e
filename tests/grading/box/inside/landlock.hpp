// Files fenced off by the kernel's Landlock: no privilege needed, and nothing to mount.
#pragma once

#include "settings.hpp"

namespace fos::grading::inside {

/// The version that this kernel has, at most `most` where that is not 0; 0: none.
int landlock_version(int most);

/// The first version that keeps signals in as well.
inline constexpr int landlock_with_signals = 6;

/// For this process and all that come of it: nothing but the paths in `settings`. False with errno
/// set where it cannot be had.
bool fence_files(const Settings& settings);

}  // namespace fos::grading::inside
