// Letters of Greek and accented Latin, in plain Latin ones.
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "encoding.hpp"
#include "file_names.hpp"

namespace fos::grading {
namespace {

/// The character at the front of UTF-8 text, and the rest.
char32_t next_character(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  char32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  text.remove_prefix(length);
  return code;
}

// U+03B1 … U+03C9, the small letters in order, with the final sigma; the capitals are 32 before.
constexpr std::array<const char*, 25> greek = {"a", "v", "g", "d", "e",  "z",  "i", "th", "i",
                                               "k", "l", "m", "n", "x",  "o",  "p", "r",  "s",
                                               "s", "t", "y", "f", "ch", "ps", "o"};
// The accented ones, which lie elsewhere.
constexpr std::pair<char32_t, const char*> greek_accented[] = {
    {0x386, "a"}, {0x388, "e"}, {0x389, "i"}, {0x38A, "i"}, {0x38C, "o"},
    {0x38E, "y"}, {0x38F, "o"}, {0x390, "i"}, {0x3AA, "i"}, {0x3AB, "y"},
    {0x3AC, "a"}, {0x3AD, "e"}, {0x3AE, "i"}, {0x3AF, "i"}, {0x3B0, "y"},
    {0x3CA, "i"}, {0x3CB, "y"}, {0x3CC, "o"}, {0x3CD, "y"}, {0x3CE, "o"}};
// U+00C0 … U+00FF.
constexpr std::string_view latin_1 =
    "aaaaaaaceeeeiiiidnooooo ouuuuytsaaaaaaaceeeeiiiidnooooo ouuuuyty";

std::string_view in_latin(char32_t code) {
  static constexpr std::string_view ascii = "0123456789abcdefghijklmnopqrstuvwxyz";
  if (code >= 'A' && code <= 'Z') code += 'a' - 'A';
  if (code < 0x80) {
    const std::size_t at = ascii.find(static_cast<char>(code));
    return at == std::string_view::npos ? " " : ascii.substr(at, 1);
  }
  if (code >= 0xC0 && code <= 0xFF) return latin_1.substr(code - 0xC0, 1);
  if (code >= 0x300 && code <= 0x36F) return "";  // an accent of its own, as macOS writes them
  for (const auto& [letter, words] : greek_accented) {
    if (letter == code) return words;
  }
  if (code >= 0x391 && code <= 0x3A9 && code != 0x3A2) code += 0x20;
  if (code >= 0x3B1 && code <= 0x3C9) return greek.at(code - 0x3B1);
  return " ";
}

}  // namespace

std::string latin(std::string_view text) {
  std::string out;
  const std::string valid = make_utf8(text);
  for (std::string_view rest = valid; !rest.empty();) {
    const char32_t code = next_character(rest);
    const bool upsilon = code == 0x3C5 || code == 0x3CD || code == 0x3A5 || code == 0x38E;
    const bool after_omicron = upsilon && out.ends_with('o');
    const std::string_view letters = after_omicron ? "u" : in_latin(code);
    if (letters != " ") {
      out += letters;
    } else if (!out.empty() && !out.ends_with(' ')) {
      out += ' ';
    }
  }
  if (out.ends_with(' ')) out.pop_back();
  return out;
}

}  // namespace fos::grading
