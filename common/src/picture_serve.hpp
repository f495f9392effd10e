// The resident picture program.
#pragma once

#include <istream>
#include <ostream>

namespace fos {

/// Makes picture after picture as picture_job.hpp has it, until the input ends. Returns the exit
/// status: 0, or 2 where something else came.
int serve_pictures(std::istream& in, std::ostream& out);

}  // namespace fos
