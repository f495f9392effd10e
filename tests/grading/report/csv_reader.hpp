// CSV as a spreadsheet reads it, for the tests of the writers.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace fos::grading {

/// RFC 4180 with any separator; a quotation mark in the middle of a cell is an ordinary character.
inline std::vector<std::vector<std::string>> read_csv(std::string_view text, char separator) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string cell;
  bool quoted = false, begun = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"') {
      if (i + 1 < text.size() && text[i + 1] == '"') {
        cell += text[i++];
      } else {
        quoted = false;
      }
    } else if (!quoted && c == '"' && !begun) {
      quoted = begun = true;
    } else if (!quoted && (c == separator || c == '\n')) {
      row.push_back(cell);
      cell.clear();
      begun = false;
      if (c == '\n') {
        rows.push_back(row);
        row.clear();
      }
    } else {
      cell += c;
      begun = true;
    }
  }
  return rows;
}

/// What a spreadsheet computes, also behind spaces and quotation marks. A number is none.
inline bool is_formula(std::string_view cell) {
  while (!cell.empty() && (cell[0] == ' ' || cell[0] == '\t' || cell[0] == '"')) {
    cell.remove_prefix(1);
  }
  if (cell.size() > 1 && cell.find_first_not_of("0123456789.", 1) == std::string_view::npos &&
      cell[0] == '-') {
    return false;
  }
  constexpr std::string_view begins[] = {"=", "+", "-", "@", "＝", "＋", "－", "＠"};
  return std::any_of(std::begin(begins), std::end(begins),
                     [&](std::string_view begin) { return cell.starts_with(begin); });
}

}  // namespace fos::grading
