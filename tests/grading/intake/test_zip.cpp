#include "test_zip.hpp"

#include <zlib.h>

#include <algorithm>

namespace fos::grading {
namespace {

void put(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

struct Packed {
  std::string bytes;
  std::uint32_t crc = 0;
};

/// Part after part, so that a bomb needs no memory here either.
class Packer {
 public:
  explicit Packer(bool deflated) : deflated_(deflated) {
    if (deflated) deflateInit2(&stream_, 1, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
  }
  ~Packer() {
    if (deflated_) deflateEnd(&stream_);
  }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  void add(const std::string& part, bool last) {
    auto* bytes = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
    packed_.crc =
        static_cast<std::uint32_t>(crc32(packed_.crc, bytes, static_cast<uInt>(part.size())));
    if (!deflated_) {
      packed_.bytes += part;
      return;
    }
    stream_.next_in = bytes;
    stream_.avail_in = static_cast<uInt>(part.size());
    std::string room(65536, '\0');
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(room.data());
      stream_.avail_out = static_cast<uInt>(room.size());
      deflate(&stream_, last ? Z_FINISH : Z_NO_FLUSH);
      packed_.bytes.append(room.data(), room.size() - stream_.avail_out);
    } while (stream_.avail_out == 0);
  }

  Packed take() { return std::move(packed_); }

 private:
  bool deflated_;
  z_stream stream_{};
  Packed packed_;
};

Packed pack(const TestEntry& entry) {
  Packer packer(entry.deflated);
  packer.add(entry.content, entry.zeros == 0);
  static const std::string zeros(1 << 20, '\0');  // once: an entry may be one of 100,000
  for (std::uint64_t left = entry.zeros; left > 0;) {
    const std::uint64_t now = std::min<std::uint64_t>(left, zeros.size());
    left -= now;
    packer.add(zeros.substr(0, static_cast<std::size_t>(now)), left == 0);
  }
  return packer.take();
}

}  // namespace

std::string zip_of(const std::vector<TestEntry>& entries) {
  std::string out;
  std::string list;
  for (const TestEntry& entry : entries) {
    const Packed packed = pack(entry);
    const std::uint64_t size =
        entry.claimed_size != UINT32_MAX ? entry.claimed_size : entry.content.size() + entry.zeros;
    std::string common;  // what the local header and the list have alike
    put(common, 20, 2);
    put(common, entry.flags, 2);
    put(common, entry.method != 0xFFFF ? entry.method : entry.deflated ? 8 : 0, 2);
    put(common, 0, 2);       // time
    put(common, 0x5A21, 2);  // 2025-01-01
    put(common, packed.crc, 4);
    put(common, packed.bytes.size(), 4);
    put(common, size, 4);
    put(common, entry.name.size(), 2);
    put(common, 0, 2);  // nothing extra

    put(list, 0x02014b50, 4);
    put(list, entry.mode == 0 ? 20 : (3 << 8) + 20, 2);
    list += common;
    put(list, 0, 2);  // no comment
    put(list, 0, 2);  // disk 0
    put(list, 0, 2);
    put(list, static_cast<std::uint64_t>(entry.mode) << 16U, 4);
    put(list, out.size(), 4);
    list += entry.name;

    put(out, 0x04034b50, 4);
    out += common + entry.name + packed.bytes;
  }
  const std::size_t list_at = out.size();
  out += list;
  if (entries.size() > 0xFFFF) {  // the count does not fit: zip64 has another place for it
    const std::size_t at = out.size();
    put(out, 0x06064b50, 4);
    put(out, 44, 8);
    put(out, 45, 2);
    put(out, 45, 2);
    put(out, 0, 8);
    put(out, entries.size(), 8);
    put(out, entries.size(), 8);
    put(out, list.size(), 8);
    put(out, list_at, 8);
    put(out, 0x07064b50, 4);
    put(out, 0, 4);
    put(out, at, 8);
    put(out, 1, 4);
  }
  put(out, 0x06054b50, 4);
  put(out, 0, 4);
  put(out, std::min<std::size_t>(entries.size(), 0xFFFF), 2);
  put(out, std::min<std::size_t>(entries.size(), 0xFFFF), 2);
  put(out, list.size(), 4);
  put(out, list_at, 4);
  put(out, 0, 2);
  return out;
}

}  // namespace fos::grading
