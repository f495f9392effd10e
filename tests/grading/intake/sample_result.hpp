// A result as a submission gives it, for tests.
#pragma once

#include <string>

#include "result.hpp"

namespace fos::grading {

/// With all that a result can have, and texts of the worst kind.
SubmissionResult sample_result(const std::string& id);

}  // namespace fos::grading
