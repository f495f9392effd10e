// The table of all submissions, which the page's script sorts and filters.
#pragma once

#include <span>

#include "class_statistics.hpp"
#include "markup_writer.hpp"
#include "summary.hpp"

namespace fos::grading {

/// A row a submission, a column a stage. Each cell has what it is sorted by in data-sort, each row
/// the words that the filter looks in, the mistakes among them, in data-words.
void add_class_table(MarkupWriter& out, std::span<const Summary> all,
                     const ClassStatistics& numbers);

}  // namespace fos::grading
