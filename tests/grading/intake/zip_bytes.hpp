// The bytes of a zip file, for libzip: from the disk or from memory.
//
// libzip keeps some hundred bytes for each file that the zip lists, before anyone can ask how many
// there are. So what it may read while it opens the zip is bounded here: a longer list is refused
// before it fills the memory.
#pragma once

#include <zip.h>

#include <cstdint>
#include <string>

namespace fos::grading {

class ZipBytes {
 public:
  ZipBytes(int owned_descriptor, std::uint64_t size) : descriptor_(owned_descriptor), size_(size) {}
  explicit ZipBytes(std::string bytes) : bytes_(std::move(bytes)), size_(bytes_.size()) {}
  ~ZipBytes();
  ZipBytes(const ZipBytes&) = delete;
  ZipBytes& operator=(const ZipBytes&) = delete;

  /// From here on at most this many bytes are read.
  void limit(std::uint64_t bytes) { left_ = bytes; }
  void no_limit() { left_ = UINT64_MAX; }
  bool limit_was_met() const { return met_; }

  std::uint64_t size() const { return size_; }

  /// The first bytes, to see what kind of file it is.
  std::string head(std::size_t length);

  /// libzip's view, for zip_open_from_source. This object must outlive it.
  zip_source_t* source(zip_error_t* error);

 private:
  static zip_int64_t answer(void* self, void* data, zip_uint64_t length, zip_source_cmd_t command);
  zip_int64_t read(void* data, std::uint64_t length);
  zip_int64_t read_at(void* data, std::uint64_t length, std::uint64_t at);

  std::string bytes_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t left_ = UINT64_MAX;
  bool met_ = false;
  zip_error_t error_{};
};

}  // namespace fos::grading
