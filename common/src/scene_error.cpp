// What is said about a wrong scene: the place, the line, a caret under the character.
#include <fmt/core.h>

#include <algorithm>

#include "fos/scene_text.hpp"
#include "fos/text.hpp"
#include "fos/utf8.hpp"

namespace fos {
namespace {

/// The line `number` of the source, without its line end.
std::string_view line_of(std::string_view source, int number) {
  for (; number > 1; --number)
    source.remove_prefix(std::min(source.find('\n'), source.size() - 1) + 1);
  source = source.substr(0, source.find('\n'));
  return source.substr(0, source.find('\r'));
}

}  // namespace

SceneError scene_error(std::string_view source, std::string_view name, Place place,
                       std::string_view message) {
  const auto column = static_cast<std::size_t>(place.column);
  std::string shown;
  std::size_t characters = 0;  // not bytes: a caret under Greek text must stand under its character
  for (std::string_view line = line_of(source, place.line); !line.empty() && characters < 200;) {
    const std::size_t length = text_length(line);
    shown += length == 0 ? "?" : std::string(line.substr(0, length));
    line.remove_prefix(std::max<std::size_t>(length, 1));
    ++characters;
  }
  std::replace(shown.begin(), shown.end(), '\t', ' ');
  const std::string caret =
      column <= characters + 1 ? fmt::format("\n  {}^", std::string(column - 1, ' ')) : "";
  return SceneError(fmt::format("{}:{}:{}: {}: {}\n  {}{}", name, place.line, place.column,
                                say(text::scene_error), message, shown, caret));
}

}  // namespace fos
