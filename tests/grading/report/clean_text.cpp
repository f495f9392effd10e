#include "clean_text.hpp"

#include "fos/utf8.hpp"

namespace fos::grading {
namespace {

constexpr char32_t replacement = 0xFFFD;

bool turns_direction(char32_t c) {
  return c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069);
}

bool is_no_character(char32_t c) { return (c >= 0xFDD0 && c <= 0xFDEF) || (c & 0xFFFE) == 0xFFFE; }

/// What is shown of a character that is no line end.
char32_t shown(char32_t c) {
  if (c == '\t') return c;
  if (c < 0x20) return 0x2400 + c;  // the pictures of the controls
  if (c == 0x7F) return 0x2421;
  if (c >= 0x80 && c <= 0x9F) return replacement;
  // The byte-order mark and the marks around annotations: invisible, and no part of any text.
  if (c == 0xFEFF || (c >= 0xFFF9 && c <= 0xFFFB)) return replacement;
  return turns_direction(c) || is_no_character(c) ? replacement : c;
}

}  // namespace

char32_t take_character(std::string_view& text) {
  const std::size_t size = utf8_length(text);
  const unsigned first = static_cast<unsigned char>(text.front());
  char32_t character = size == 0 ? replacement : size == 1 ? first : first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    character = character << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  text.remove_prefix(size == 0 ? 1 : size);
  return character;
}

void append_character(std::string& out, char32_t character) {
  const auto c = static_cast<unsigned>(character);
  const auto add = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (c < 0x80) return add(c);
  if (c < 0x800) {
    add(0xC0 | c >> 6U);
  } else if (c < 0x10000) {
    add(0xE0 | c >> 12U);
  } else {
    add(0xF0 | c >> 18U);
    add(0x80 | (c >> 12U & 0x3FU));
  }
  if (c >= 0x800) add(0x80 | (c >> 6U & 0x3FU));
  add(0x80 | (c & 0x3FU));
}

std::string clean(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const char32_t c = take_character(text);
    if (c == '\r') {
      if (!text.starts_with('\n')) out += '\n';
    } else if (c == '\n' || c == 0x2028 || c == 0x2029) {
      out += '\n';
    } else {
      append_character(out, shown(c));
    }
  }
  return out;
}

std::string one_line(std::string_view text) {
  std::string out;
  for (const char c : clean(text)) {
    const bool white = c == ' ' || c == '\t' || c == '\n';
    if (!white) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  if (out.ends_with(' ')) out.pop_back();
  return out;
}

std::string shortened(std::string_view text, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; !text.empty(); ++i) {
    if (i == most) return out + "…";
    append_character(out, take_character(text));
  }
  return out;
}

}  // namespace fos::grading
