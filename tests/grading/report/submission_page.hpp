// The page of one submission, for its student.
#pragma once

#include <string>

#include "result.hpp"

namespace fos::grading {

/// One HTML file that refers to nothing but the pictures beside it; above all not to the page of
/// the class, which is nobody's but the instructor's.
std::string submission_page(const Run& run, const SubmissionResult& submission);

}  // namespace fos::grading
