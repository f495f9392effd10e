// On what the measurements were made.
#pragma once

#include <string>

namespace fos::numerics {

/// As the system calls it; empty where it does not say.
std::string processor_name();

/// With its version.
std::string compiler_name();

}  // namespace fos::numerics
