// The study as a table for a terminal of 80 columns, and as CSV.
#pragma once

#include <string>

#include "study.hpp"

namespace fos::numerics {

/// In the person's language, with the legend.
std::string table_of(const Study& study);

/// RFC 4180, with a header row, every number to its last digit; the same in every language.
std::string csv_of(const Study& study);

}  // namespace fos::numerics
