// One thing to do in the box: a program, what it may see, and how much it may use.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace fos::grading {

/// What may be used. The processor time decides, not the clock: a busy machine fails nobody.
struct BoxLimits {
  unsigned cpu_seconds = 10;  ///< for one question, or for the whole errand where there is none
  std::uint64_t memory = 1ULL << 30;  ///< bytes, of all its processes together
  bool address_space = true;  ///< a process may reserve twice that; a sanitizer reserves terabytes
  std::uint64_t file_size = 8ULL << 20;  ///< bytes, of one file
  std::uint64_t written = 32ULL << 20;   ///< bytes, of all files
  unsigned processes = 16;
  unsigned idle_seconds = 10;  ///< for how long it may do nothing while it is waited for
};

/// A file or folder of ours that the box shows, for reading. Where the box has no file system of
/// its own, it is seen where it is.
struct Shown {
  std::filesystem::path host;  ///< absolute
  std::string inside;          ///< begins with /box/
};

struct Errand {
  /// The program and its arguments. What is shown is named as it is inside; Box::command puts the
  /// place that it really has, so each `inside` is not the beginning of another.
  std::vector<std::string> words;
  std::vector<Shown> shown;
  /// Where it may write, and where it starts: an empty folder in memory if there is none. Made
  /// over to the box's user.
  std::filesystem::path folder;
  bool compiler = false;                 ///< needs the compiler and its headers, not only libraries
  std::vector<std::string> environment;  ///< NAME=VALUE, beside PATH, HOME and LC_ALL
  BoxLimits limits;
};

/// Where `folder` is inside, and where an errand starts.
inline constexpr const char* inside_folder = "/box/work";

}  // namespace fos::grading
