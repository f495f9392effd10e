#include "csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <optional>

#include "encoding.hpp"
#include "file_names.hpp"
#include "limits.hpp"

namespace fos::grading {
namespace {

bool is_line_end(char letter) { return letter == '\n' || letter == '\r'; }

std::string trimmed(std::string_view text) {
  const std::string_view spaces = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(spaces);
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(spaces) - begin + 1));
}

/// What separates fields: the sign that the first row has most of, outside quotation marks.
char separator_of(std::string_view text) {
  std::size_t commas = 0;
  std::size_t semicolons = 0;
  std::size_t tabs = 0;
  bool quoted = false;
  for (const char letter : text) {
    if (letter == '"') quoted = !quoted;
    if (quoted) continue;
    if (is_line_end(letter) && commas + semicolons + tabs > 0) break;
    commas += letter == ',' ? 1 : 0;
    semicolons += letter == ';' ? 1 : 0;
    tabs += letter == '\t' ? 1 : 0;
  }
  if (semicolons >= commas && semicolons >= tabs && semicolons > 0) return ';';
  return tabs > commas ? '\t' : ',';
}

class Parser {
 public:
  Parser(std::string_view text, std::string file) : text_(text) { table_.file = std::move(file); }

  Table parse() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    if (text_.substr(at_, 4) == "sep=" && at_ + 4 < text_.size()) {
      separator_ = text_[at_ + 4];
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    } else {
      separator_ = separator_of(text_.substr(at_));
    }
    while (at_ < text_.size()) row();
    return std::move(table_);
  }

 private:
  bool ends() const { return at_ == text_.size() || is_line_end(text_[at_]); }

  void line_end() {
    if (at_ == text_.size()) return;
    at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    ++line_;
  }

  void row() {
    TableRow row;
    row.line = line_;
    for (;;) {
      row.cells.push_back(cell());
      if (ends()) break;
      ++at_;  // the separator
    }
    line_end();
    const bool empty = std::all_of(row.cells.begin(), row.cells.end(),
                                   [](const std::string& cell) { return cell.empty(); });
    if (!empty) table_.rows.push_back(std::move(row));
  }

  std::string cell() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ < text_.size() && text_[at_] == '"') return quoted_cell();
    const std::size_t begin = at_;
    while (!ends() && text_[at_] != separator_) ++at_;
    return trimmed(text_.substr(begin, at_ - begin));
  }

  std::string quoted_cell() {
    const int began = line_;
    std::string out;
    for (++at_;;) {
      if (at_ == text_.size())
        throw TableError(table_.file, began, say(text::intake_csv_open_quote));
      if (text_[at_] != '"') {
        if (text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_, 2) != "\r\n")) ++line_;
        out += text_[at_++];
      } else if (text_.substr(at_, 2) == "\"\"") {
        out += '"';
        at_ += 2;
      } else {
        break;
      }
    }
    ++at_;
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (!ends() && text_[at_] != separator_) {
      throw TableError(table_.file, line_, say(text::intake_csv_after_quote));
    }
    return trimmed(out);
  }

  std::string_view text_;
  Table table_;
  std::size_t at_ = 0;
  int line_ = 1;
  char separator_ = ',';
};

}  // namespace

TableError::TableError(std::string_view file, int line, std::string_view message)
    : std::runtime_error(
          fmt::format("{}:{}: {}: {}", file, line, say(text::scene_error), message)) {}

TableError::TableError(std::string_view file, std::string_view message)
    : std::runtime_error(fmt::format("{}: {}: {}", file, say(text::scene_error), message)) {}

Table parse_table(std::string_view text, std::string file) {
  return Parser(text, std::move(file)).parse();
}

Table read_table(const std::filesystem::path& path) {
  const std::string name = shown_path(path.string());
  std::error_code failed;
  const auto size = std::filesystem::file_size(path, failed);  // fails for what is no file
  if (failed) throw TableError(name, failed.message());
  if (size > most_table) throw TableError(name, say(text::intake_too_much));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw TableError(name, say(text::intake_not_allowed));
  auto plain = read_text(std::move(bytes));
  if (!plain) throw TableError(name, say(text::intake_csv_not_text));
  return parse_table(plain->words, name);
}

std::vector<std::string> column_names(const Table& table) {
  std::vector<std::string> names;
  if (table.rows.empty()) return names;
  for (const std::string& cell : table.rows.front().cells) names.push_back(latin(cell));
  return names;
}

}  // namespace fos::grading
