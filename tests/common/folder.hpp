// An empty folder of a test's own, gone at the end.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace fos {

struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fos test " + std::to_string(getpid()));

  Folder() { std::filesystem::create_directory(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  long entries() const { return std::distance(std::filesystem::directory_iterator(path), {}); }
};

}  // namespace fos
