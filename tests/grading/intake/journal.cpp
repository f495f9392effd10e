#include "journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include "file_names.hpp"
#include "fos/text.hpp"
#include "limits.hpp"

namespace fos::grading {
namespace {

constexpr std::size_t most_result = 16 * mebibyte;

std::string in_words(int error) { return std::generic_category().message(error); }

FileError cannot_write(const std::filesystem::path& path, int error) {
  const bool disk = error == ENOSPC || error == EDQUOT || error == EIO || error == ENOLCK;
  return FileError(disk ? 3 : 2, say(text::tool_cannot_write, {path.string(), in_words(error)}));
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw cannot_write(path, error.value());
}

std::optional<std::string> read_all(int descriptor) {
  std::string out;
  std::array<char, 65536> part;
  for (;;) {
    const ssize_t got = ::read(descriptor, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) return out;
    out.append(part.data(), static_cast<std::size_t>(got));
    if (out.size() > most_result) return std::nullopt;
  }
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  auto out = read_all(descriptor);
  close(descriptor);
  return out;
}

/// Writes all, and waits until it is on the disk. 0, or the error.
int write_through(const std::filesystem::path& path, std::string_view words) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return errno;
  int error = 0;
  while (!words.empty() && error == 0) {
    const ssize_t done = ::write(descriptor, words.data(), words.size());
    if (done >= 0) {
      words.remove_prefix(static_cast<std::size_t>(done));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && fsync(descriptor) != 0) error = errno;
  if (close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

/// Makes a new name in a folder last, as far as the disk can.
void keep_names(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/// Locks the file, or says who has it.
int take_lock(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "journal.lock";
  const int lock = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (lock < 0) throw cannot_write(path, errno);
  if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    const std::string who = error == EWOULDBLOCK ? read_all(lock).value_or("") : "";
    close(lock);
    if (error != EWOULDBLOCK) throw cannot_write(path, error);
    throw FileError(2, say(text::intake_locked_folder,
                           {folder.string(), shown_path(who.substr(0, who.find('\n')))}));
  }
  const std::string who = std::to_string(getpid()) + "\n";
  // Only for the words above: a full disk is found out where it matters.
  if (ftruncate(lock, 0) == 0 && pwrite(lock, who.data(), who.size(), 0) < 0) errno = 0;
  return lock;
}

}  // namespace

Journal::Journal(std::filesystem::path folder) : folder_(std::move(folder)) {
  make_folder(folder_ / "results");
  lock_ = take_lock(folder_);
}

Journal::~Journal() { close(lock_); }

void Journal::load() {
  const std::lock_guard<std::mutex> one_at_a_time(busy_);
  heads_.clear();
  damaged_.clear();
  std::error_code error;
  std::filesystem::directory_iterator folders(folder_ / "results", error);
  for (; !error && folders != std::filesystem::directory_iterator(); folders.increment(error)) {
    const std::string id = folders->path().filename().string();
    const std::filesystem::path path = folders->path() / "result.json";
    struct stat status {};
    if (lstat(path.c_str(), &status) != 0) continue;  // begun, and not finished
    try {
      const auto json = read_file(path);
      if (!json) throw JsonError("unreadable");
      ResultHead head = head_from_json(*json);
      if (head.id != id) throw JsonError("another's");
      heads_.emplace(id, std::move(head));
    } catch (const JsonError&) {
      damaged_.push_back(id);
    }
  }
  if (error) {
    throw FileError(
        2, say(text::intake_no_path, {(folder_ / "results").string(), in_words(error.value())}));
  }
}

bool Journal::is_finished(std::string_view id, std::string_view key) const {
  const std::lock_guard<std::mutex> one_at_a_time(busy_);
  const auto found = heads_.find(id);
  return found != heads_.end() && found->second.key == key &&
         found->second.status != Status::not_judged;
}

std::optional<SubmissionResult> Journal::read(std::string_view id) const {
  if (!is_safe_id(id)) return std::nullopt;
  const auto json = read_file(folder_ / "results" / id / "result.json");
  if (!json) return std::nullopt;
  try {
    SubmissionResult result = result_from_json(*json);
    if (result.id == id) return result;
  } catch (const JsonError&) {
  }
  return std::nullopt;
}

std::filesystem::path Journal::folder_of(std::string_view id) const {
  std::filesystem::path folder = folder_ / "results" / id;
  if (!is_safe_id(id)) throw cannot_write(folder, EINVAL);
  make_folder(folder);
  return folder;
}

void Journal::write(const SubmissionResult& result) {
  const std::string json = to_json(result);
  const std::lock_guard<std::mutex> one_at_a_time(busy_);
  const std::filesystem::path folder = folder_of(result.id);
  WholeFile file(folder / "result.json");
  if (const int error = write_through(file.temporary(), json); error != 0) {
    throw file.write_error(in_words(error));
  }
  file.commit();
  keep_names(folder);
  heads_.insert_or_assign(result.id, ResultHead{result.id, result.key, result.status});
}

}  // namespace fos::grading
