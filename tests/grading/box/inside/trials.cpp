#include "trials.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace fos::grading::inside {
namespace {

bool can_read(const char* path) {
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  char byte = 0;
  struct stat status {};
  const bool folder = fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
  return folder || read(file, &byte, 1) >= 0;
}

/// Into a folder: a file of its own, which is gone again at once.
bool can_write(const std::string& path) {
  const std::string file = path + "/.fos-trial";
  const int made = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (made >= 0) unlink(file.c_str());
  return made >= 0;
}

}  // namespace

int run_trial(int count, char** words) {
  int i = 2;
  for (; i < count && std::string_view(words[i]) != "--"; ++i) {
    if (can_read(words[i])) {
      puts(words[i]);
      return read_a_secret;
    }
    if (can_write(words[i])) return wrote_outside;
  }
  for (const char* path : {"/usr/bin", "/usr/lib", "/etc", "/"}) {
    if (can_write(path)) return wrote_outside;
  }
  for (++i; i < count; ++i) {
    const auto pid = static_cast<pid_t>(std::atoi(words[i]));
    if (pid > 1 && kill(pid, 0) == 0) return reached_a_process;
  }
  if (socket(AF_INET, SOCK_STREAM, 0) >= 0) return opened_a_socket;
  return fenced;
}

}  // namespace fos::grading::inside
