// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fos {

/// What stands in the way of a file, ready to print. `exit_status` is 2 where the path is wrong, 3
/// where the disk is.
class FileError : public std::runtime_error {
 public:
  FileError(int status, const std::string& message)
      : std::runtime_error(message), exit_status(status) {}
  int exit_status;
};

/// A file in the making: it is written under a temporary name in the same folder and takes its own
/// name, over any older file, at commit(). Without that, also on Ctrl-C, nothing is left of it.
/// One at a time in a process.
class WholeFile {
 public:
  /// Makes the temporary file, empty. Throws FileError.
  explicit WholeFile(std::filesystem::path destination);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }

  /// Puts the file in its place. Throws FileError.
  void commit();

  /// The error to throw where writing failed half-way: the disk is full, or gone.
  FileError write_error(const std::string& reason) const;

 private:
  std::filesystem::path destination_;
  std::filesystem::path temporary_;
};

/// A file of these words, whole or not at all. Throws FileError.
void write_whole_file(const std::filesystem::path& path, const std::string& words);

}  // namespace fos
