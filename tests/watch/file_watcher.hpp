// A file, looked at again and again: that works on network folders and on those that Windows and
// Linux share, where no system call tells of changes.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace fos {

class FileWatcher {
 public:
  using Clock = std::chrono::steady_clock;

  /// What is there now is no change.
  explicit FileWatcher(std::filesystem::path path);

  enum class Change {
    none,
    changed,
    missing  ///< it has been gone for a second: told once, for an editor that replaces a file takes
             ///< it away for a moment
  };

  /// Looks. A change is another content, or another time of change; that alone is not enough where
  /// times are in whole seconds.
  Change look(Clock::time_point now = Clock::now());

  /// What the file had in it when it was last there.
  const std::string& content() const { return content_; }

 private:
  struct Seen {
    std::filesystem::file_time_type time;
    std::string content;
  };
  std::optional<Seen> see() const;

  std::filesystem::path path_;
  std::filesystem::file_time_type time_;
  std::string content_;
  bool was_missing_ = false;
  bool told_ = false;  // that it is missing
  Clock::time_point gone_since_;
};

}  // namespace fos
