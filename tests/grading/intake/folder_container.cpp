// A folder on the disk. Every step goes through the descriptor of the folder before it and none
// through a link, so that what lies outside is never touched, whatever changes meanwhile.
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <string_view>
#include <utility>

#include "container.hpp"
#include "file_names.hpp"
#include "limits.hpp"

namespace fos::grading {
namespace {

/// A descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }
  void replace(int number) {
    if (number_ >= 0) close(number_);
    number_ = number;
  }

 private:
  int number_;
};

[[noreturn]] void fail_by_errno() {
  throw ContainerError(errno == EACCES || errno == EPERM ? Trouble::not_allowed : Trouble::changed);
}

constexpr int no_links = O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY;

FileKind kind_of(mode_t mode) {
  if (S_ISREG(mode)) return FileKind::regular;
  if (S_ISDIR(mode)) return FileKind::folder;
  return S_ISLNK(mode) ? FileKind::link : FileKind::special;
}

class Folder : public Container {
 public:
  Folder(int owned, ListLimits limits) : root_(owned), limits_(limits) {}

  void list(const std::function<void(const FileEntry&)>& visit) override {
    std::size_t left = limits_.files;
    walk(fcntl(root_.number(), F_DUPFD_CLOEXEC, 0), "", 0, left, visit);
  }

  std::string read(const FileEntry& entry, std::size_t most) override {
    const Descriptor file(open_regular(entry.path));
    std::string out;
    std::array<char, 65536> part;
    for (;;) {
      const ssize_t got = ::read(file.number(), part.data(), part.size());
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw ContainerError(Trouble::damaged);
      if (got == 0) return out;
      out.append(part.data(), static_cast<std::size_t>(got));
      if (out.size() > most) throw ContainerError(Trouble::too_large);
    }
  }

  std::unique_ptr<Container> open_zip(const FileEntry& entry, std::size_t& /*budget*/) override {
    // Read where it lies, so that its size costs nothing.
    return open_zip_descriptor(open_regular(entry.path), {most_directory, most_files});
  }

 private:
  void walk(int owned, const std::string& path, std::size_t depth, std::size_t& left,
            const std::function<void(const FileEntry&)>& visit);

  int open_regular(const std::string& path) {
    Descriptor at(fcntl(root_.number(), F_DUPFD_CLOEXEC, 0));
    const auto parts = parts_of(path);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const int flags = i + 1 < parts.size() ? no_links | O_DIRECTORY : no_links;
      at.replace(openat(at.number(), std::string(parts[i]).c_str(), flags));
      if (at.number() < 0) fail_by_errno();
    }
    struct stat status {};
    if (fstat(at.number(), &status) != 0 || !S_ISREG(status.st_mode))
      throw ContainerError(Trouble::changed);
    return at.release();
  }

  Descriptor root_;
  ListLimits limits_;
};

void Folder::walk(int owned, const std::string& path, std::size_t depth, std::size_t& left,
                  const std::function<void(const FileEntry&)>& visit) {
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(fdopendir(owned), closedir);
  if (!folder) {
    const int error = errno;
    if (owned >= 0) close(owned);
    errno = error;
    fail_by_errno();
  }
  rewinddir(folder.get());  // the root's descriptor shares its position with an earlier walk
  std::vector<std::string> below;
  while (const dirent* found = readdir(folder.get())) {
    const std::string_view name = found->d_name;
    if (name == "." || name == "..") continue;
    if (left-- == 0) throw ContainerError(Trouble::too_many_files);
    struct stat status {};
    if (fstatat(dirfd(folder.get()), found->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    FileEntry entry;
    entry.path = path + found->d_name;
    entry.kind = kind_of(status.st_mode);
    entry.size = static_cast<std::uint64_t>(status.st_size);
    visit(entry);
    if (entry.kind == FileKind::folder && !is_clutter(name)) below.emplace_back(name);
  }
  std::sort(below.begin(), below.end());
  for (const std::string& name : below) {
    const std::string inner_path = path + name;
    const bool deep = depth + 1 >= most_depth;
    const int inner = deep ? -1 : openat(dirfd(folder.get()), name.c_str(), no_links | O_DIRECTORY);
    if (inner < 0) {
      visit({inner_path, FileKind::closed});
      continue;
    }
    walk(inner, inner_path + "/", depth + 1, left, visit);
  }
}

}  // namespace

std::unique_ptr<Container> open_folder(const std::filesystem::path& path, ListLimits limits) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
  if (descriptor < 0) fail_by_errno();
  return std::make_unique<Folder>(descriptor, limits);
}

}  // namespace fos::grading
