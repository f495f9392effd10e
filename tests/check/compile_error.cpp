#include "compile_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "clean_message.hpp"
#include "compile_words.hpp"
#include "compiler_output.hpp"
#include "fos/text.hpp"
#include "layout.hpp"

namespace fos {
namespace {

bool is_letter_start(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// By folder and name: the compiler was called in the build folder, and this program was not.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
  return one.filename() == other.filename() &&
         (one.parent_path().empty() || other.parent_path().empty() ||
          one.parent_path().filename() == other.parent_path().filename());
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

/// Where the file has to do with the error: in it, or the way to it begins there.
const SourcePlace* place_in(const std::filesystem::path& file, const Diagnostic& error) {
  if (is_same_file(error.place.file, file)) return &error.place;
  for (const auto kind : {Related::Kind::requested, Related::Kind::note, Related::Kind::included}) {
    for (const Related& related : error.related) {
      if (related.kind == kind && is_same_file(related.place.file, file)) return &related.place;
    }
  }
  return nullptr;
}

/// g++ says this of a function when it ends, before it sees the brace that ended it too early.
bool may_follow_from_later(const Diagnostic& error) {
  return error.message.find("no return statement") != std::string::npos ||
         error.message.find("does not return a value") != std::string::npos;
}

/// A column as characters of the line.
int in_characters(const std::string& line, int column, bool bytes) {
  int at = 1;      // in the compiler's columns
  int number = 1;  // in characters
  for (std::size_t i = 0; i < line.size() && at < column; ++i) {
    if (bytes) {
      ++at;
      const bool ends = i + 1 == line.size() || is_letter_start(line[i + 1]);
      number += ends ? 1 : 0;
    } else if (is_letter_start(line[i])) {
      at = line[i] == '\t' ? (at + 7) / 8 * 8 + 1 : at + 1;
      ++number;
    }
  }
  return number;
}

/// A missing semicolon is noticed at the next word, which may stand in a later line.
void move_to_end_of_line_before(CompileContext& context, int& column) {
  const std::size_t first = context.source().find_first_not_of(" \t");
  const bool at_first =
      first != std::string::npos && column <= columns_of(context.source().substr(0, first)) + 1;
  if (!at_first) return;
  for (int line = context.line - 1; line >= 1; --line) {
    std::string code = context.lines[static_cast<std::size_t>(line - 1)];
    code.erase(std::min(code.find("//"), code.size()));
    const std::size_t end = code.find_last_not_of(" \t");
    if (end == std::string::npos) continue;
    context.line = line;
    column = columns_of(code.substr(0, end + 1)) + 1;
    return;
  }
}

CompileError describe(const Diagnostic& error, const SourcePlace* place,
                      const CompilerOutput& output, const std::filesystem::path& file) {
  CompileContext context{clean_message(error.message), {}, lines_of(file), 0};
  for (const Related& related : error.related) {
    if (!related.message.empty()) context.notes.push_back(clean_message(related.message));
  }
  int column = 0;
  if (place != nullptr) {
    context.line = place->line;
    column = in_characters(context.source(), place->column, output.columns_are_bytes);
    if (place->column == 0) column = 0;
    const bool semicolon = context.message.find("';' before") != std::string::npos;
    if (semicolon && place == &error.place) move_to_end_of_line_before(context, column);
  }
  CompileError found{context.line, column, context.message, context.source(),
                     compile_word(context)};
  // What the compiler guesses is worth less than what is known of the slides' names.
  if (!found.word.empty()) {
    found.message.erase(std::min(found.message.find("; did you mean"), found.message.size()));
  }
  return found;
}

/// The line with a caret below, in a window of it where it is long.
std::string with_caret(const CompileError& error) {
  std::string line = error.source;
  std::replace(line.begin(), line.end(), '\t', ' ');
  const std::string margin = fmt::format("{:>5} | ", error.line);
  const int room = terminal_width - columns_of(margin);
  const int first = error.column > room - 10 ? error.column - room / 2 : 0;  // characters left out
  std::string shown;
  int at = 0;
  for (const char byte : line) {
    at += is_letter_start(byte) ? 1 : 0;
    if (at > first && at <= first + room) shown += byte;
  }
  std::string out = margin + shown + "\n";
  if (error.column > 0) {
    out += std::string(margin.size() - 2, ' ') + "| " +
           std::string(static_cast<std::size_t>(error.column - 1 - first), ' ') + "^\n";
  }
  return out;
}

/// At most this many characters.
std::string shortened(const std::string& text, int most) {
  if (columns_of(text) <= most) return text;
  std::string out;
  int at = 0;
  for (const char byte : text) {
    at += is_letter_start(byte) ? 1 : 0;
    if (at < most) out += byte;
  }
  return out + "…";
}

std::string end_of(std::string_view output) {
  constexpr int most = 5;
  std::vector<std::string_view> lines;
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    if (end > 0) lines.push_back(output.substr(0, end));
    output.remove_prefix(std::min(end + 1, output.size()));
  }
  std::string out;
  const auto from = std::max<std::ptrdiff_t>(0, std::ssize(lines) - most);
  for (auto i = static_cast<std::size_t>(from); i < lines.size(); ++i) {
    out += shortened(std::string(lines[i]), terminal_width - 2) + "\n";
  }
  return out;
}

}  // namespace

std::optional<CompileError> find_compile_error(std::string_view output,
                                               const std::filesystem::path& file) {
  const CompilerOutput read = read_compiler_output(output);
  const Diagnostic* found = nullptr;
  for (const Diagnostic& error : read.errors) {
    const bool linker = error.place.file.empty();
    if (!linker && place_in(file, error) == nullptr) continue;
    const bool better = found == nullptr || (found->place.file.empty() && !linker) ||
                        (may_follow_from_later(*found) && !linker);
    if (better) found = &error;
  }
  if (found == nullptr) return std::nullopt;
  return describe(*found, place_in(file, *found), read, file);
}

std::string describe_compile_error(std::string_view output, const std::filesystem::path& file,
                                   std::string_view name) {
  const auto error = find_compile_error(output, file);
  if (!error) return wrapped(say(text::compile_unknown)) + wrapped(end_of(output), 2);
  std::string where(name);
  if (error->line > 0) where += fmt::format(":{}", error->line);
  if (error->line > 0 && error->column > 0) where += fmt::format(":{}", error->column);
  std::string out = wrapped(where + ": " + shortened(error->message, 180));
  if (!error->source.empty()) out += with_caret(*error);
  return out + wrapped(error->word, 2);
}

}  // namespace fos
