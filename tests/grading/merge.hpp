// The results of a class that was graded in parts (`--part I/N`), put together.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grade_options.hpp"

namespace fos::grading {

struct Merged {
  std::size_t results = 0;
  std::size_t not_judged = 0;
  std::vector<std::string> refused;  ///< what platforms would refuse, in words
};

/// Writes into `asked.output` what one run over the whole class would have written there:
/// results, pictures, pages, the files of the class. Throws FileError where the parts are not all
/// there, finished, and of one run (then nothing is written), or where one of their results is
/// damaged.
Merged merge_parts(const GradeOptions& asked);

}  // namespace fos::grading
