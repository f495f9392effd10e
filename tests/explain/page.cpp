#include "page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "layout.hpp"

namespace fos {
namespace {

// Two blanks, name, right, yours, mark.
constexpr std::size_t name_columns = 24;
constexpr std::size_t right_columns = 35;
constexpr std::size_t yours_columns = 16;

std::string padded(std::string_view text, std::size_t columns) {
  const auto used = static_cast<std::size_t>(columns_of(text));
  return std::string(text) + std::string(used < columns ? columns - used : 0, ' ');
}

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

void Page::line(std::string_view words) { text_ += std::string(words) + '\n'; }

void Page::paragraph(std::string_view words) {
  std::string current;
  while (!words.empty()) {
    const std::size_t end = words.find(' ');
    const std::string_view word = words.substr(0, end);
    if (!current.empty() && columns_of(current) + 1 + columns_of(word) > terminal_width) {
      line(current);
      current.clear();
    }
    if (!current.empty()) current += ' ';
    current += word;
    words.remove_prefix(end == std::string_view::npos ? words.size() : end + 1);
  }
  line(current);
}

void Page::row(std::string_view name, std::string_view right, std::string_view yours, Mark mark) {
  const std::string out = "  " + padded(name, name_columns) + padded(right, right_columns);
  switch (mark) {
    case Mark::none:
      line(trimmed(out + std::string(yours)));
      break;
    case Mark::unseen:
      line(out + painted(" –", mark));
      break;
    case Mark::open:
      line(trimmed(out + " " + padded(yours, yours_columns) + "~"));
      break;
    case Mark::same:
    case Mark::different:
      line(out + " " + padded(yours, yours_columns) +
           painted(mark == Mark::same ? "✓" : "✗", mark));
      break;
  }
}

std::string Page::painted(std::string_view words, Mark mark) const {
  if (!colors_) return std::string(words);
  const char* color = mark == Mark::same        ? "\033[32m"
                      : mark == Mark::different ? "\033[31m"
                                                : "\033[2m";
  return fmt::format("{}{}\033[0m", color, words);
}

}  // namespace fos
