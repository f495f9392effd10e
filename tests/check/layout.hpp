// Text for a terminal: 80 columns, and colors only where they are wanted.
#pragma once

#include <string>
#include <string_view>

namespace fos {

inline constexpr int terminal_width = 80;

/// How many columns UTF-8 text takes, if every character takes one.
int columns_of(std::string_view text);

/// Lines broken between words where they are longer than `width`; all are indented by `indent`
/// spaces. Ends with a line end; line ends in `text` stay.
std::string wrapped(std::string_view text, int indent = 0, int width = terminal_width);

/// Whether standard output is one.
bool is_terminal();

/// What a terminal can show.
enum class Colors { none, some, indexed, full };  ///< none; the 16; 256; 24 bits

/// What standard output can show: nothing where it is no terminal or where NO_COLOR is set
/// (no-color.org), else by TERM and COLORTERM.
Colors colors_of_output();

/// Words in a color, where there are colors.
class Paint {
 public:
  explicit Paint(Colors colors) : colors_(colors) {}
  Colors colors() const { return colors_; }
  std::string green(std::string_view text) const { return in("32", text); }
  std::string red(std::string_view text) const { return in("31", text); }
  std::string yellow(std::string_view text) const { return in("33", text); }
  std::string bold(std::string_view text) const { return in("1", text); }
  std::string dim(std::string_view text) const { return in("2", text); }

 private:
  std::string in(std::string_view code, std::string_view text) const;
  Colors colors_;
};

}  // namespace fos
