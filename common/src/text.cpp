#include "fos/text.hpp"

#include <cstdlib>

namespace fos {

Language language() {
  for (const char* name : {"FOS_LANG", "LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') {
      return std::string_view(value).starts_with("el") ? Language::el : Language::en;
    }
  }
  return Language::en;
}

std::string say(const Text& text, std::initializer_list<std::string_view> values) {
  const std::string_view pattern = language() == Language::el ? text.el : text.en;
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool placeholder = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}' &&
                             pattern[i + 1] >= '0' && pattern[i + 1] <= '9';
    if (!placeholder) {
      out += pattern[i];
      continue;
    }
    const auto index = static_cast<std::size_t>(pattern[i + 1] - '0');
    if (index < values.size()) out += values.begin()[index];
    i += 2;
  }
  return out;
}

}  // namespace fos
