#include "compiler_output.hpp"

#include <cctype>
#include <optional>

namespace fos {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Takes `:NUMBER` from the front; 0 where there is none.
int take_number(std::string_view& text) {
  if (text.size() < 2 || text[0] != ':' || !is_digit(text[1])) return 0;
  int number = 0;
  text.remove_prefix(1);
  while (!text.empty() && is_digit(text[0]) && number < 100'000'000) {
    number = 10 * number + (text[0] - '0');
    text.remove_prefix(1);
  }
  return number;
}

/// Takes `FILE:LINE` or `FILE:LINE:COLUMN` from the front.
std::optional<SourcePlace> take_place(std::string_view& text) {
  for (std::size_t i = text.find(':'); i != std::string_view::npos; i = text.find(':', i + 1)) {
    std::string_view rest = text.substr(i);
    const int line = take_number(rest);
    if (line == 0) continue;
    const int column = take_number(rest);
    SourcePlace place{std::string(text.substr(0, i)), line, column};
    text = rest;
    return place;
  }
  return std::nullopt;
}

bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

class Reader {
 public:
  void read(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (is_inclusion(line) || is_link_error(line)) return;
    if (line.ends_with(" error generated.") || line.ends_with(" errors generated.")) {
      output.columns_are_bytes = true;
    }
    const std::optional<SourcePlace> place = take_place(line);
    if (!place || !take(line, ": ")) return;
    if (take(line, "error: ") || take(line, "fatal error: ")) {
      output.errors.push_back({*place, std::string(line), std::move(before_)});
      in_error_ = true;
      before_.clear();
    } else if (take(line, "warning: ")) {
      in_error_ = false;
      before_.clear();
    } else if (take(line, "note: ")) {
      const bool requested = line.ends_with("requested here");
      if (in_error_) {
        output.errors.back().related.push_back(
            {requested ? Related::Kind::requested : Related::Kind::note, *place,
             std::string(line)});
      }
      before_.clear();
    } else if (line.find("required ") != std::string_view::npos) {
      before_.push_back({Related::Kind::requested, *place, ""});
    }
  }

  CompilerOutput output;

 private:
  /// `In file included from FILE:1,` and the lines that go on with it.
  bool is_inclusion(std::string_view line) {
    if (!take(line, "In file included from ")) {
      const std::size_t first = line.find_first_not_of(' ');
      if (first == 0 || first == std::string_view::npos) return false;
      line.remove_prefix(first);
      if (!take(line, "from ")) return false;
    }
    const std::optional<SourcePlace> place = take_place(line);
    if (place) before_.push_back({Related::Kind::included, *place, ""});
    return place.has_value();
  }

  bool is_link_error(std::string_view line) {
    for (const std::string_view what : {"undefined reference to ", "multiple definition of "}) {
      const std::size_t found = line.find(what);
      if (found == std::string_view::npos) continue;
      Diagnostic& error = output.errors.emplace_back();
      error.message = line.substr(found);
      in_error_ = true;
      before_.clear();
      return true;
    }
    return false;
  }

  std::vector<Related> before_;  // what was said ahead of the next message
  bool in_error_ = false;        // notes belong to an error
};

}  // namespace

CompilerOutput read_compiler_output(std::string_view output) {
  Reader reader;
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    reader.read(output.substr(0, end));
    output.remove_prefix(std::min(end + 1, output.size()));
  }
  return std::move(reader.output);
}

}  // namespace fos
