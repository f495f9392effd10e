#include "file_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <map>

#include "digest.hpp"
#include "encoding.hpp"
#include "limits.hpp"

namespace fos::grading {

std::optional<std::string> clean_path(std::string_view path) {
  if (path.size() > most_path) return std::nullopt;
  std::string turned(path);
  std::replace(turned.begin(), turned.end(), '\\', '/');
  std::string_view rest = turned;
  if (rest.size() >= 2 && std::isalpha(static_cast<unsigned char>(rest[0])) != 0 &&
      rest[1] == ':') {
    rest.remove_prefix(2);
  }
  std::string out;
  for (const std::string_view part : parts_of(rest)) {
    if (part.empty() || part == ".") continue;
    if (part == "..") return std::nullopt;
    if (!out.empty()) out += '/';
    out += part;
  }
  if (out.empty()) return std::nullopt;
  return out;
}

std::vector<std::string_view> parts_of(std::string_view path) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t slash = path.find('/');
    parts.push_back(path.substr(0, slash));
    if (slash == std::string_view::npos) return parts;
    path.remove_prefix(slash + 1);
  }
}

std::string_view file_name(std::string_view path) {
  return path.substr(path.rfind('/') + 1);  // npos + 1 is 0
}

std::string shown_path(std::string_view path) {
  static constexpr std::size_t longest = 200;
  std::string out;
  if (path.size() > longest) {
    out = make_utf8(path.substr(0, longest / 4)) + "…" +
          make_utf8(path.substr(path.size() - 3 * longest / 4));
  } else {
    out = make_utf8(path);
  }
  for (char& byte : out) {
    if (static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F) byte = '?';
  }
  return out;
}

bool is_clutter(std::string_view path) {
  const auto parts = parts_of(path);
  return std::any_of(parts.begin(), parts.end(), [](std::string_view part) {
    const std::string name = lower(part);
    return name.starts_with('.') || name == "__macosx" || name == "thumbs.db" ||
           name == "desktop.ini";
  });
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& letter : out) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter + ('a' - 'A'));
  }
  return out;
}

bool is_zip_name(std::string_view name) { return lower(name).ends_with(".zip"); }

std::string_view other_archive(std::string_view name) {
  static constexpr std::array<std::string_view, 12> endings = {
      ".rar", ".7z",  ".tar.gz", ".tar.bz2", ".tar.xz", ".tar.zst",
      ".tar", ".tgz", ".gz",     ".bz2",     ".xz",     ".zst"};
  const std::string small = lower(name);
  const auto found = std::find_if(endings.begin(), endings.end(),
                                  [&](std::string_view end) { return small.ends_with(end); });
  return found == endings.end() ? std::string_view() : *found;
}

std::string safe_id(std::string_view name) {
  // What latin() makes a space may be a mark that an id can keep.
  std::string out;
  std::size_t begin = 0;
  const auto flush = [&](std::size_t end) {
    std::string words = latin(name.substr(begin, end - begin));
    std::replace(words.begin(), words.end(), ' ', '-');
    out += words;
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] != '.' && name[i] != '_' && name[i] != '-') continue;
    flush(i);
    if (!out.empty() && out.back() != name[i]) out += name[i];
    begin = i + 1;
  }
  flush(name.size());
  if (out.size() > 64) out.resize(64);
  while (!out.empty() && std::isalnum(static_cast<unsigned char>(out.back())) == 0) out.pop_back();
  return out.empty() ? "submission" : out;
}

bool is_safe_id(std::string_view id) {
  static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  static constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789._-";
  return !id.empty() && id.size() <= 128 && letters.find(id.front()) != std::string_view::npos &&
         id.find_first_not_of(allowed) == std::string_view::npos;
}

std::vector<std::string> unique_ids(const std::vector<std::string>& names,
                                    const std::vector<std::string>& sources) {
  std::vector<std::string> ids;
  std::map<std::string, int> taken;
  for (const std::string& name : names) ++taken[ids.emplace_back(safe_id(name))];
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (taken[ids[i]] > 1) ids[i] += "-" + sha256(sources[i]).substr(0, 8);
  }
  // Two that are equal even so have one source, or mean it: they are counted.
  std::map<std::string, int> again;
  for (std::string& id : ids) {
    const int before = again[id]++;
    if (before > 0) id += "." + std::to_string(before + 1);
  }
  return ids;
}

}  // namespace fos::grading
