// Patterns with holes, for the messages of a compiler.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fos {

/// What stands in the holes `*` of the pattern where it first occurs in the text; each hole takes
/// as little as it can, the last one, at the pattern's end, all the rest.
inline std::optional<std::vector<std::string>> matches(std::string_view text,
                                                       std::string_view pattern) {
  std::vector<std::string> holes;
  bool first = true;
  while (true) {
    const std::size_t star = pattern.find('*');
    const std::string_view part = pattern.substr(0, star);
    const std::size_t found = text.find(part);
    if (found == std::string_view::npos) return std::nullopt;
    if (!first) holes.emplace_back(part.empty() ? text : text.substr(0, found));
    if (star == std::string_view::npos) return holes;
    text.remove_prefix(found + part.size());
    pattern.remove_prefix(star + 1);
    first = false;
  }
}

}  // namespace fos
