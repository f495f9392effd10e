#include "encoding.hpp"

#include <iconv.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <cstdint>

#include "fos/utf8.hpp"

namespace fos::grading {
namespace {

bool is_high(char byte) { return (static_cast<unsigned char>(byte) & 0x80U) != 0; }

/// Whether some word has letters of ASCII and others: accented Latin, so not Greek.
bool mixes_letters(std::string_view bytes) {
  bool latin = false;
  bool other = false;
  for (const char byte : bytes) {
    const bool letter = std::isalpha(static_cast<unsigned char>(byte)) != 0 && !is_high(byte);
    if (!letter && !is_high(byte)) latin = other = false;
    latin = latin || letter;
    other = other || is_high(byte);
    if (latin && other) return true;
  }
  return false;
}

/// Control characters that are no white space: no one types them.
bool has_controls(std::string_view bytes) {
  return std::any_of(bytes.begin(), bytes.end(), [](char byte) {
    const auto code = static_cast<unsigned char>(byte);
    return code == 0x7F || (code < 0x20 && (code < '\t' || code > '\r'));
  });
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = utf8_length(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::optional<std::string> from_encoding(const char* encoding, std::string_view bytes) {
  iconv_t converter = iconv_open("UTF-8", encoding);
  if (reinterpret_cast<std::intptr_t>(converter) == -1)
    return std::nullopt;  // this libc knows it not
  std::string in(bytes);
  std::string out(4 * in.size() + 4, '\0');
  char* from = in.data();
  char* to = out.data();
  std::size_t left = in.size();
  std::size_t room = out.size();
  const bool wrong = iconv(converter, &from, &left, &to, &room) == static_cast<std::size_t>(-1);
  iconv_close(converter);
  if (wrong) return std::nullopt;
  out.resize(out.size() - room);
  return out;
}

std::optional<PlainText> read_text(std::string bytes) {
  const std::string_view mark = std::string_view(bytes).substr(0, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF") {
    const char* encoding = mark == "\xFF\xFE" ? "UTF-16LE" : "UTF-16BE";
    auto words = from_encoding(encoding, std::string_view(bytes).substr(2));
    if (!words || words->find('\0') != std::string::npos) return std::nullopt;
    return PlainText{*std::move(words), "UTF-16"};
  }
  if (bytes.find('\0') != std::string::npos) return std::nullopt;
  if (is_utf8(bytes)) return PlainText{std::move(bytes)};
  if (has_controls(bytes)) return std::nullopt;
  auto words = from_encoding("CP1253", bytes);
  if (!words) return std::nullopt;
  return PlainText{*std::move(words), "Windows-1253"};
}

std::string read_name(std::string_view bytes) {
  if (is_utf8(bytes)) return std::string(bytes);
  if (auto name = from_encoding(mixes_letters(bytes) ? "CP437" : "CP737", bytes)) return *name;
  return make_utf8(bytes);
}

std::string make_utf8(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      out += "\uFFFD";
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

}  // namespace fos::grading
