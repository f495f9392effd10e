// Text as it comes from students' and instructors' machines, made UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fos::grading {

/// Whether all of `bytes` is UTF-8 (RFC 3629). NUL and other control characters are allowed.
bool is_utf8(std::string_view bytes);

/// `bytes` in another encoding, by its name, as UTF-8; nothing where they are none of it.
std::optional<std::string> from_encoding(const char* encoding, std::string_view bytes);

/// What a file of text holds, and what it was saved as.
struct PlainText {
  std::string words;
  const char* encoding = "UTF-8";  ///< or "UTF-16", "Windows-1253"
};

/// A text file: UTF-8 as it is, UTF-16 with its byte-order mark (an old Notepad's "Unicode"), else
/// Windows-1253, in which Greek editors and Excel save. Nothing where it is none of these: bytes
/// that no text has.
std::optional<PlainText> read_text(std::string bytes);

/// A file's name in a zip. Where it is not UTF-8, the tools of a Greek Windows wrote it in the code
/// page 737, those of most others in 437; a word of letters of both kinds is none of the first.
std::string read_name(std::string_view bytes);

/// `text` with what is not UTF-8 replaced by U+FFFD.
std::string make_utf8(std::string_view text);

}  // namespace fos::grading
