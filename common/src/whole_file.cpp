#include "fos/whole_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>

#include "fos/text.hpp"

namespace fos {
namespace {

std::string in_words(int error) { return std::generic_category().message(error); }

// What a signal handler may touch: plain memory. Empty when there is nothing to remove.
std::array<char, 4096> pending{};

void remove_pending(int signal) {
  if (pending[0] != '\0') unlink(pending.data());
  std::signal(signal, SIG_DFL);
  raise(signal);
}

void set_pending(const std::string& path) {
  if (path.size() >= pending.size()) {
    throw FileError(2, say(text::tool_cannot_write, {path, in_words(ENAMETOOLONG)}));
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // A signal that is ignored (nohup) stays ignored, and a program that ends in order keeps its
    // own way.
    const auto before = std::signal(signal, remove_pending);
    if (before != SIG_DFL && before != remove_pending) std::signal(signal, before);
  }
  // The first byte last, so that the handler never sees half a name.
  std::memcpy(pending.data() + 1, path.c_str() + 1, path.size());
  std::atomic_signal_fence(std::memory_order_release);
  pending[0] = path[0];
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path destination) : destination_(std::move(destination)) {
  std::error_code ignored;
  if (std::filesystem::is_directory(destination_, ignored)) {
    throw FileError(2, say(text::tool_cannot_write, {destination_.string(), in_words(EISDIR)}));
  }
  const std::filesystem::path folder = destination_.parent_path();
  const std::string name =
      fmt::format(".{}.{}.part", destination_.filename().string(), static_cast<long>(getpid()));
  temporary_ = folder.empty() ? std::filesystem::path(name) : folder / name;
  set_pending(temporary_.string());
  unlink(temporary_.c_str());  // what a killed process of the same number may have left
  const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  const int descriptor = open(temporary_.c_str(), flags, 0666);
  if (descriptor < 0) {
    const int error = errno;
    pending[0] = '\0';
    const bool disk = error == ENOSPC || error == EDQUOT || error == EIO;
    throw FileError(disk ? 3 : 2,
                    say(text::tool_cannot_write, {destination_.string(), in_words(error)}));
  }
  close(descriptor);
}

WholeFile::~WholeFile() {
  if (!temporary_.empty()) unlink(temporary_.c_str());
  pending[0] = '\0';
}

void WholeFile::commit() {
  if (std::rename(temporary_.c_str(), destination_.c_str()) != 0)
    throw write_error(in_words(errno));
  temporary_.clear();
  pending[0] = '\0';
}

FileError WholeFile::write_error(const std::string& reason) const {
  return FileError(3, say(text::tool_cannot_write, {destination_.string(), reason}));
}

void write_whole_file(const std::filesystem::path& path, const std::string& words) {
  WholeFile file(path);
  std::ofstream out(file.temporary(), std::ios::binary);
  out << words;
  out.close();
  if (!out) throw file.write_error(in_words(errno));
  file.commit();
}

}  // namespace fos
