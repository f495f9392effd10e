// Characters of UTF-8 text.
#pragma once

#include <cstddef>
#include <string_view>

namespace fos {

/// The length in bytes of the character at the front of `text`; 0 where there is none (RFC 3629).
std::size_t utf8_length(std::string_view text);

/// The same, and 0 for a control character that is no white space: no text file has one.
std::size_t text_length(std::string_view text);

}  // namespace fos
