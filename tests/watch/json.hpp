// Values as JavaScript reads them, in a file that is a script.
#pragma once

#include <string>
#include <string_view>

namespace fos {

/// In quotation marks. Whatever is in `text`, the result is one string of JavaScript and of JSON,
/// in valid UTF-8: bytes that are none become the replacement character.
std::string json_string(std::string_view text);

/// The standard alphabet, padded.
std::string base64(std::string_view bytes);

}  // namespace fos
