// A folder or a zip, seen alike: files with paths, which are listed, and read one at a time.
//
// Nothing is ever unpacked to the disk: the few small files that are wanted are read into memory,
// so a path is only a name here, and what it says leads nowhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fos::grading {

/// What a file is, or what is wrong with it.
enum class FileKind {
  regular,
  folder,
  link,       ///< a symbolic link
  special,    ///< a device, a pipe, a socket
  encrypted,  ///< with a password
  outside,    ///< its name leads out of its folder
  closed      ///< a folder that may not be looked into
};

struct FileEntry {
  std::string path;  ///< relative, with '/', UTF-8 or as the disk has it
  FileKind kind = FileKind::regular;
  std::uint64_t size = 0;   ///< as the zip or the disk claims
  std::uint64_t index = 0;  ///< the zip's own
  std::size_t own_from =
      0;  ///< where the hand-in's part of the path begins: before it is the class

  std::string_view own_path() const { return std::string_view(path).substr(own_from); }
};

/// Why a folder, zip or file cannot be read.
enum class Trouble {
  none,
  not_a_zip,
  damaged,
  encrypted,
  too_large,       ///< more than may be read of it
  too_many_files,  ///< or too long a list of them
  too_deep,        ///< zips in zips, or folders in folders
  unsupported,     ///< a way of packing that is not known here
  not_allowed,     ///< the disk's rights
  changed          ///< it is not what it was when it was listed
};

class ContainerError : public std::runtime_error {
 public:
  explicit ContainerError(Trouble what) : std::runtime_error("container"), trouble(what) {}
  Trouble trouble;
};

/// Not for two threads at once.
class Container {
 public:
  Container() = default;
  Container(const Container&) = delete;
  Container& operator=(const Container&) = delete;
  virtual ~Container() = default;

  /// Visits all that is in it, in no order that means anything. Throws ContainerError.
  virtual void list(const std::function<void(const FileEntry&)>& visit) = 0;

  /// The bytes of a regular file. Throws ContainerError; too_large where there are more than
  /// `most`.
  virtual std::string read(const FileEntry& entry, std::size_t most) = 0;

  /// A file in it as a zip of its own. `budget` are the bytes that may yet be unpacked for it; it
  /// is charged. Throws ContainerError.
  virtual std::unique_ptr<Container> open_zip(const FileEntry& entry, std::size_t& budget) = 0;
};

/// How much of a container is listed.
struct ListLimits {
  std::uint64_t directory;  ///< bytes of a zip's list
  std::size_t files;
};

/// A folder. Links below it are never followed. Throws ContainerError.
std::unique_ptr<Container> open_folder(const std::filesystem::path& path, ListLimits limits);

/// A zip file on the disk, or in memory. Throws ContainerError.
std::unique_ptr<Container> open_zip_file(const std::filesystem::path& path, ListLimits limits);
std::unique_ptr<Container> open_zip_descriptor(int owned, ListLimits limits);
std::unique_ptr<Container> open_zip_bytes(std::string bytes, ListLimits limits);

}  // namespace fos::grading
