#include "escape.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "clean_text.hpp"

namespace fos::grading {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// What nobody sees, and what the comparison of strings in .NET, in which the runner of GitHub is
/// written, skips: a `::` with one of them inside may still be a `::` to it.
bool is_invisible(char32_t c) {
  return c == 0x00AD || c == 0x034F || c == 0x115F || c == 0x1160 || c == 0x17B4 || c == 0x17B5 ||
         (c >= 0x180B && c <= 0x180F) || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2060 && c <= 0x206F) || c == 0x3164 || (c >= 0xFE00 && c <= 0xFE0F) ||
         c == 0xFFA0 || (c >= 0xE0000 && c <= 0xE0FFF);
}

/// With which a cell is a formula, in the forms that spreadsheets read.
bool begins_formula(std::string_view text) {
  constexpr std::string_view begins[] = {"=", "+", "-", "@", "＝", "＋", "－", "＠"};
  return std::any_of(std::begin(begins), std::end(begins),
                     [&](std::string_view begin) { return text.starts_with(begin); });
}

std::string without_formulas(std::string_view text) {
  std::string out;
  bool at_begin = true;  // of a cell, as this or another separator may cut it
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (at_begin && begins_formula(text.substr(i))) out += '\'';
    at_begin = (at_begin && text[i] == ' ') ||
               std::string_view(R"(,;|")").find(text[i]) != std::string_view::npos;
    out += text[i];
  }
  return out;
}

/// Every mark of ASCII that may be markup as its number, which Markdown never reads as markup.
std::string without_markup(std::string_view text, std::string_view line_end) {
  std::string out;
  for (const char c : clean(text)) {
    if (c == '\n') {
      out += line_end;
    } else if (is_letter_or_digit(c) || !is_ascii(c) ||
               std::string_view(" ,()").find(c) != std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("&#{};", static_cast<int>(c));
    }
  }
  return out;
}

}  // namespace

std::string markup(std::string_view text) {
  std::string out;
  for (const char c : clean(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '`':  // an old browser's quotation mark
        out += "&#96;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string address(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (is_letter_or_digit(c) || std::string_view("-_.~").find(c) != std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  // Nothing but dots would be another folder.
  return std::all_of(out.begin(), out.end(), [](char c) { return c == '.'; }) ? "_" : out;
}

std::string csv_cell(std::string_view text) {
  std::string cell = without_formulas(one_line(text));
  if (cell.find_first_of(R"(,;|"')") == std::string::npos) return cell;
  std::string out = R"(")";
  for (const char c : cell) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

bool is_plain_cell(std::string_view text) { return without_formulas(one_line(text)) == text; }

std::string workflow_text(std::string_view text) {
  std::string out;
  const std::string cleaned = clean(text);
  for (std::string_view rest = cleaned; !rest.empty();) {
    const char32_t c = take_character(rest);
    if (is_invisible(c)) continue;
    // A space between the two: a character of no width would be skipped as well.
    if ((c == ':' && out.ends_with(':')) || (c == '#' && out.ends_with('#'))) out += ' ';
    append_character(out, c);
  }
  return out;
}

std::string markdown(std::string_view text) { return without_markup(text, "<br>"); }

std::string markdown_block(std::string_view text) { return without_markup(text, "\n"); }

}  // namespace fos::grading
