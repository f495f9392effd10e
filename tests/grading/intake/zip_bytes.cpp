#include "zip_bytes.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace fos::grading {

ZipBytes::~ZipBytes() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::string ZipBytes::head(std::size_t length) {
  std::string out(length, '\0');
  const zip_int64_t got = read_at(out.data(), length, 0);
  out.resize(static_cast<std::size_t>(std::max<zip_int64_t>(got, 0)));
  return out;
}

zip_source_t* ZipBytes::source(zip_error_t* error) {
  zip_error_init(&error_);
  return zip_source_function_create(answer, this, error);
}

zip_int64_t ZipBytes::read_at(void* data, std::uint64_t length, std::uint64_t at) {
  if (at >= size_) return 0;
  const auto wanted = static_cast<std::size_t>(std::min(length, size_ - at));
  if (descriptor_ < 0) {
    std::memcpy(data, bytes_.data() + at, wanted);
    return static_cast<zip_int64_t>(wanted);
  }
  ssize_t got = 0;
  do {
    got = pread(descriptor_, data, wanted, static_cast<off_t>(at));
  } while (got < 0 && errno == EINTR);
  if (got < 0) zip_error_set(&error_, ZIP_ER_READ, errno);
  return got;
}

zip_int64_t ZipBytes::read(void* data, std::uint64_t length) {
  if (length > left_) {
    met_ = true;
    zip_error_set(&error_, ZIP_ER_INCONS, 0);
    return -1;
  }
  const zip_int64_t got = read_at(data, length, position_);
  if (got < 0) return got;
  position_ += static_cast<std::uint64_t>(got);
  if (left_ != UINT64_MAX) left_ -= static_cast<std::uint64_t>(got);
  return got;
}

zip_int64_t ZipBytes::answer(void* self, void* data, zip_uint64_t length,
                             zip_source_cmd_t command) {
  auto& bytes = *static_cast<ZipBytes*>(self);
  switch (command) {
    case ZIP_SOURCE_OPEN:
      bytes.position_ = 0;
      return 0;
    case ZIP_SOURCE_READ:
      return bytes.read(data, length);
    case ZIP_SOURCE_SEEK: {
      const zip_int64_t to =
          zip_source_seek_compute_offset(bytes.position_, bytes.size_, data, length, &bytes.error_);
      if (to < 0) return -1;
      bytes.position_ = static_cast<std::uint64_t>(to);
      return 0;
    }
    case ZIP_SOURCE_TELL:
      return static_cast<zip_int64_t>(bytes.position_);
    case ZIP_SOURCE_STAT: {
      auto* stat = static_cast<zip_stat_t*>(data);
      zip_stat_init(stat);
      stat->size = bytes.size_;
      stat->valid = ZIP_STAT_SIZE;
      return sizeof(zip_stat_t);
    }
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(&bytes.error_, data, length);
    case ZIP_SOURCE_CLOSE:
    case ZIP_SOURCE_FREE:
      return 0;
    case ZIP_SOURCE_SUPPORTS:
      return ZIP_SOURCE_SUPPORTS_SEEKABLE;
    default:
      zip_error_set(&bytes.error_, ZIP_ER_OPNOTSUPP, 0);
      return -1;
  }
}

}  // namespace fos::grading
