#include "platform_names.hpp"

#include <algorithm>
#include <cctype>

#include "file_names.hpp"

namespace fos::grading {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

std::size_t digits_at_end(std::string_view text) {
  std::size_t count = 0;
  while (count < text.size() && is_digit(text[text.size() - 1 - count])) ++count;
  return count;
}

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char letter) {
    return letter == ' ' || letter == '\t' || letter == '\r';
  };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// A value as YAML writes it on one line: plain, or in quotation marks of either kind.
std::string yaml_value(std::string_view text) {
  text = trimmed(text);
  if (text == "null" || text == "~") return "";
  if (text.size() < 2 || (text.front() != '"' && text.front() != '\'')) return std::string(text);
  const char quote = text.front();
  std::string out;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const bool escaped = quote == '"' ? text[i] == '\\' : text.substr(i, 2) == "''";
    if (escaped && i + 2 < text.size()) ++i;
    out += text[i];
  }
  return out;
}

/// Adds a group's next member after a comma.
void append(std::string& list, const std::string& more) {
  if (!more.empty()) list += (list.empty() ? "" : ", ") + more;
}

}  // namespace

std::optional<MoodleName> moodle_name(std::string_view file) {
  static constexpr std::string_view mark = "_assignsubmission_";
  const std::size_t at = file.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view before = file.substr(0, at);
  const std::size_t digits = digits_at_end(before);
  if (digits == 0 || digits + 1 >= before.size()) return std::nullopt;
  if (before[before.size() - digits - 1] != '_') return std::nullopt;
  std::size_t rest = file.find('_', at + mark.size());  // after `file` or `onlinetext`
  rest = rest == std::string_view::npos ? file.size() : rest + 1;
  return MoodleName{std::string(before.substr(0, before.size() - digits - 1)),
                    std::string(before.substr(before.size() - digits)), rest};
}

Whose eclass_name(std::string_view stem) {
  Whose whose;
  const std::size_t digits = digits_at_end(stem);
  const std::size_t number = digits >= 3 && digits < stem.size() ? digits : 0;
  whose.name = trimmed(stem.substr(0, stem.size() - number));
  whose.number = stem.substr(stem.size() - number);
  return whose;
}

bool is_eclass_folder(std::string_view name) {
  return name.starts_with("work_") && digits_at_end(name) == name.size() - 5 && name.size() > 5;
}

std::map<std::string, Whose> gradescope_names(std::string_view yaml) {
  std::map<std::string, Whose> names;
  Whose* whose = nullptr;
  bool among_submitters = false;
  while (!yaml.empty()) {
    const std::size_t end = std::min(yaml.find('\n'), yaml.size());
    const std::string_view line = yaml.substr(0, end);
    yaml.remove_prefix(std::min(end + 1, yaml.size()));
    std::string_view words = trimmed(line);
    if (words.empty()) continue;
    const bool at_margin = line.front() != ' ' && line.front() != '-';
    if (at_margin) {
      const std::size_t colon = words.rfind(':');
      const bool is_folder = words.starts_with("submission_") && colon != std::string_view::npos;
      whose = is_folder ? &names[std::string(words.substr(0, colon))] : nullptr;
      among_submitters = false;
      continue;
    }
    if (words.starts_with("- ")) words = trimmed(words.substr(2));
    if (!words.starts_with(':') || whose == nullptr) continue;
    const std::size_t colon = words.find(':', 1);
    if (colon == std::string_view::npos) continue;
    const std::string_view key = words.substr(1, colon - 1);
    const std::string value = yaml_value(words.substr(colon + 1));
    if (key == "submitters") {
      among_submitters = true;
    } else if (among_submitters && key == "name") {
      append(whose->name, value);
    } else if (among_submitters && key == "sid") {
      append(whose->number, value);
    } else if (among_submitters && key == "email") {
      append(whose->email, value);
    } else {
      among_submitters =
          false;  // :created_at and what follows, with results of other people's code
    }
  }
  return names;
}

}  // namespace fos::grading
