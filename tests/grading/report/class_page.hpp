// The page of a class, for the instructor.
#pragma once

#include <span>
#include <string>

#include "result.hpp"
#include "summary.hpp"

namespace fos::grading {

/// One HTML file: the distribution of the marks, stage by stage, the commonest mistakes, and all
/// submissions in a table, each with a link to submissions/ID/index.html.
std::string class_page(const Run& run, std::span<const Summary> all);

}  // namespace fos::grading
