// What the program inside the box is told on its command line: NAME=VALUE…, --, the program and its
// arguments. Box::command writes it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fos::grading::inside {

struct Settings {
  bool alone = false;        ///< namespaces stand around it: it is process 1, and sees no other
  bool landlock = false;     ///< files are fenced by Landlock: `read`, `write`, `device`
  int landlock_abi = 0;      ///< at most this version of it (for tests); 0: whatever there is
  bool lenient = false;      ///< it starts also where the kernel does not filter system calls
  bool shared_user = false;  ///< the user has other processes, which are in reach
  uid_t user = 0;            ///< to become, with a group of the same number; 0: stay

  unsigned cpu_seconds = 10;              ///< of one question
  std::uint64_t memory = 1ULL << 30;      ///< bytes, of all processes together
  std::uint64_t address_space = 0;        ///< bytes, of each process; 0: no limit
  std::uint64_t file_size = 16ULL << 20;  ///< bytes, of each file
  std::uint64_t written = 64ULL << 20;    ///< bytes, in `scratch` altogether
  unsigned processes = 16;
  unsigned descriptors = 64;
  unsigned idle_seconds = 10;

  std::string folder;                    ///< to start in
  std::string scratch;                   ///< where it may write: watched
  std::vector<std::string> read;         ///< paths it may read and execute
  std::vector<std::string> write;        ///< folders where it may do all
  std::vector<std::string> device;       ///< files it may read and write
  std::vector<std::string> environment;  ///< NAME=VALUE
  char** command = nullptr;              ///< ends with a null pointer
};

/// False where the words are wrong: they come from Box::command, so this is a mistake of ours.
bool parse(int count, char** words, Settings& settings);

}  // namespace fos::grading::inside
