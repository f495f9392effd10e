#include "layout.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace fos {
namespace {

bool has(const char* variable, std::string_view part) {
  const char* value = std::getenv(variable);
  return value != nullptr && std::string_view(value).find(part) != std::string_view::npos;
}

std::string wrapped_line(std::string_view line, int indent, int width) {
  const std::size_t spaces = std::min(line.find_first_not_of(' '), line.size());
  indent += static_cast<int>(spaces);
  line.remove_prefix(spaces);
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  if (indent + columns_of(line) <= width) return margin + std::string(line) + "\n";
  std::string out;
  int used = width;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    if (word.empty()) continue;
    if (used + 1 + columns_of(word) > width) {
      out.append(out.empty() ? "" : "\n").append(margin);
      used = indent - 1;
    } else {
      out += ' ';
    }
    out += word;
    used += 1 + columns_of(word);
  }
  return out + "\n";
}

}  // namespace

int columns_of(std::string_view text) {
  const auto starts = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; };
  return static_cast<int>(std::count_if(text.begin(), text.end(), starts));
}

std::string wrapped(std::string_view text, int indent, int width) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += wrapped_line(text.substr(0, end), indent, width);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

bool is_terminal() { return isatty(STDOUT_FILENO) == 1; }

Colors colors_of_output() {
  const char* no_color = std::getenv("NO_COLOR");
  if ((no_color != nullptr && *no_color != '\0') || !is_terminal()) return Colors::none;
  if (has("TERM", "dumb") || std::getenv("TERM") == nullptr) return Colors::none;
  if (has("COLORTERM", "truecolor") || has("COLORTERM", "24bit")) return Colors::full;
  return has("TERM", "256color") ? Colors::indexed : Colors::some;
}

std::string Paint::in(std::string_view code, std::string_view text) const {
  if (colors_ == Colors::none) return std::string(text);
  return std::string("\033[").append(code).append("m").append(text).append("\033[0m");
}

}  // namespace fos
