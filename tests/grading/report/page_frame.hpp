// What every page of a report has around it.
#pragma once

#include <string>
#include <string_view>

#include "markup_writer.hpp"

namespace fos::grading {

/// A whole HTML page in the language of this process, complete in itself: style and script are in
/// it, and its policy lets nothing else run and nothing be loaded but pictures beside it.
std::string whole_page(std::string_view title, const MarkupWriter& body, bool with_script);

/// The class of CSS for a mark: good, part, bad or none.
std::string_view tone(int points, int most, bool judged);

/// A bar that is filled as far as points of most: an SVG, for the policy allows no style of its
/// own.
void add_meter(MarkupWriter& out, int points, int most);

}  // namespace fos::grading
