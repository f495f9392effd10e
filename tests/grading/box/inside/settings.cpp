#include "settings.hpp"

#include <charconv>
#include <string_view>

namespace fos::grading::inside {
namespace {

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool add(std::vector<std::string>& to, std::string_view value) {
  to.emplace_back(value);
  return !value.empty();
}

bool set(std::string_view name, std::string_view value, Settings& to) {
  if (name == "alone") return to.alone = true;
  if (name == "landlock") return (to.landlock = true) && read_number(value, to.landlock_abi);
  if (name == "lenient") return to.lenient = true;
  if (name == "shared-user") return to.shared_user = true;
  if (name == "user") return read_number(value, to.user);
  if (name == "cpu") return read_number(value, to.cpu_seconds);
  if (name == "memory") return read_number(value, to.memory);
  if (name == "address-space") return read_number(value, to.address_space);
  if (name == "file-size") return read_number(value, to.file_size);
  if (name == "written") return read_number(value, to.written);
  if (name == "processes") return read_number(value, to.processes);
  if (name == "descriptors") return read_number(value, to.descriptors);
  if (name == "idle") return read_number(value, to.idle_seconds);
  if (name == "folder") return !(to.folder = value).empty();
  if (name == "scratch") return !(to.scratch = value).empty();
  if (name == "read") return add(to.read, value);
  if (name == "write") return add(to.write, value);
  if (name == "device") return add(to.device, value);
  if (name == "env") return add(to.environment, value);
  return false;
}

}  // namespace

bool parse(int count, char** words, Settings& settings) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--") {
      settings.command = words + i + 1;
      return i + 1 < count;
    }
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos) return false;
    if (!set(word.substr(0, equals), word.substr(equals + 1), settings)) return false;
  }
  return false;
}

}  // namespace fos::grading::inside
