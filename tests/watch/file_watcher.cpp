#include "file_watcher.hpp"

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace fos {

FileWatcher::FileWatcher(std::filesystem::path path) : path_(std::move(path)) {
  if (const auto seen = see()) {
    time_ = seen->time;
    content_ = seen->content;
  } else {
    was_missing_ = true;
    gone_since_ = Clock::now();
  }
}

std::optional<FileWatcher::Seen> FileWatcher::see() const {
  // The time first: a change after it is a change to be seen at the next look.
  std::error_code error;
  const auto time = std::filesystem::last_write_time(path_, error);
  if (error) return std::nullopt;
  std::ifstream in(path_, std::ios::binary);
  if (!in) return std::nullopt;
  std::string content{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) return std::nullopt;
  return Seen{time, std::move(content)};
}

FileWatcher::Change FileWatcher::look(Clock::time_point now) {
  const auto seen = see();
  if (!seen) {
    if (!std::exchange(was_missing_, true)) gone_since_ = now;
    if (now - gone_since_ < std::chrono::seconds(1) || std::exchange(told_, true)) {
      return Change::none;
    }
    return Change::missing;
  }
  was_missing_ = false;
  const bool was_told = std::exchange(told_, false);
  if (seen->time == time_ && seen->content == content_ && !was_told) return Change::none;
  time_ = seen->time;
  content_ = seen->content;
  return Change::changed;
}

}  // namespace fos
