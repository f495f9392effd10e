// Text that a student made, as text: before anything is escaped for where it goes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fos::grading {

/// Takes the character at the front of `text`, which is not empty: one byte at least. Bytes that
/// are no UTF-8 (RFC 3629) are U+FFFD, one by one.
char32_t take_character(std::string_view& text);

void append_character(std::string& out, char32_t character);

/// Valid UTF-8 whose only controls are line feed and tab, and which is valid in XML 1.0. Other
/// controls of ASCII are shown (an escape is ␛), what else a terminal obeys or what turns the
/// direction of reading is U+FFFD; lines end in line feeds.
std::string clean(std::string_view text);

/// The same in one line: each run of white space is a space, none at its ends.
std::string one_line(std::string_view text);

/// At most `most` characters of it, … for the rest.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace fos::grading
