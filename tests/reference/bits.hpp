// Streams of bits, the highest bit of a byte first, and how a reference codes whole numbers in
// them.
//
// What follows is written once for both directions: a function that takes `Bits& bits` and a number
// writes the number with a BitWriter, and reads it into the same variable with a BitReader.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "reference_file.hpp"

namespace fos::reference {

class BitWriter {
 public:
  static constexpr bool is_writing = true;

  /// The lowest `count` bits of `value`; 0 <= count <= 64.
  void bits(std::uint64_t& value, int count) {
    for (int i = count - 1; i >= 0; --i) {
      byte_ = (byte_ << 1) | ((value >> i) & 1);
      if (++used_ == 8) flush();
    }
  }

  /// All that was written, with 0 bits up to a whole byte.
  std::string take() {
    if (used_ > 0) {
      byte_ <<= 8 - used_;
      flush();
    }
    return std::move(bytes_);
  }

 private:
  void flush() {
    bytes_.push_back(static_cast<char>(byte_));
    used_ = 0;
  }

  std::string bytes_;
  std::uint64_t byte_ = 0;  ///< its lowest `used_` bits
  int used_ = 0;
};

class BitReader {
 public:
  static constexpr bool is_writing = false;

  explicit BitReader(std::span<const char> bytes) : bytes_(bytes) {}

  /// The next `count` bits; 0 <= count <= 64. Throws ReferenceError after the last byte.
  void bits(std::uint64_t& value, int count) {
    value = 0;
    if (count > 32) {
      value = take(count - 32);
      count = 32;
    }
    value = (value << count) | take(count);
  }

  /// Whether only the 0 bits are left that fill the last byte.
  bool is_at_end() const { return next_ == bytes_.size() && filled_ < 8 && buffer_ == 0; }

 private:
  std::uint64_t take(int count) {
    if (count == 0) return 0;
    while (filled_ < count) {
      if (next_ == bytes_.size()) throw ReferenceError("ends too early");
      buffer_ |= std::uint64_t{static_cast<std::uint8_t>(bytes_[next_++])} << (56 - filled_);
      filled_ += 8;
    }
    const std::uint64_t result = buffer_ >> (64 - count);
    buffer_ <<= count;
    filled_ -= count;
    return result;
  }

  std::span<const char> bytes_;
  std::size_t next_ = 0;
  std::uint64_t buffer_ = 0;  ///< the next bits, from the highest; 0 after them
  int filled_ = 0;
};

/// A number as a Golomb-Rice code: n / 2^k in unary (1...10), then the k low bits of n. Where the
/// unary part would be long: that many 1 bits, the number of bits of n less one in 6 bits, and n.
template <class Bits>
void code_rice(Bits& bits, std::uint64_t& n, int k) {
  constexpr std::uint64_t longest_unary = 24;
  std::uint64_t quotient = 0;
  const std::uint64_t wanted = std::min(n >> k, longest_unary);
  for (; quotient < longest_unary; ++quotient) {
    std::uint64_t more = quotient < wanted;
    bits.bits(more, 1);
    if (more == 0) break;
  }
  if (quotient < longest_unary) {
    std::uint64_t low = n & ((std::uint64_t{1} << k) - 1);
    bits.bits(low, k);
    n = (quotient << k) | low;
  } else {
    std::uint64_t width = static_cast<std::uint64_t>(std::bit_width(n | 1)) - 1;
    bits.bits(width, 6);
    bits.bits(n, static_cast<int>(width) + 1);
  }
}

/// The k that suits numbers of this mean. Larger ones than 2^56 are not expected.
inline int rice_parameter(std::uint64_t mean) {
  return std::min(static_cast<int>(std::bit_width(mean)), 56);
}

/// Signed numbers as unsigned ones: 0, -1, 1, -2 ... are 0, 1, 2, 3 ...
inline std::uint64_t zigzag(std::int64_t n) {
  return (static_cast<std::uint64_t>(n) << 1) ^ static_cast<std::uint64_t>(n >> 63);
}
inline std::int64_t unzigzag(std::uint64_t n) {
  return static_cast<std::int64_t>((n >> 1) ^ (0 - (n & 1)));
}

/// Codes a row of numbers of about the same size, by their running mean.
class NumberCoder {
 public:
  template <class Bits>
  void code(Bits& bits, std::uint64_t& n) {
    code_rice(bits, n, rice_parameter(sixteen_means_ / 16));
    sixteen_means_ += std::min(n, max_counted) - sixteen_means_ / 16;
  }

  template <class Bits>
  void code(Bits& bits, std::int64_t& n) {
    std::uint64_t unsigned_n = zigzag(n);
    code(bits, unsigned_n);
    n = unzigzag(unsigned_n);
  }

 private:
  static constexpr std::uint64_t max_counted = std::uint64_t{1} << 56;

  std::uint64_t sixteen_means_ = 0;
};

}  // namespace fos::reference
