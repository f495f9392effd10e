// Numbers drawn from a seed: the same ones on every machine.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <string>

namespace fos::certified {

/// Numbers as decimals of a few digits, made of whole numbers only (Steele, Lea, Flood: SplitMix).
class Random {
 public:
  /// Neighbouring seeds are far apart: their first states are outputs of the generator itself.
  explicit Random(std::uint64_t seed) : state_(seed) { state_ = bits(); }

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  int below(int limit) { return static_cast<int>(bits() % static_cast<std::uint64_t>(limit)); }
  bool once_in(int times) { return below(times) == 0; }
  int between(int low, int high) { return low + below(high - low + 1); }

  /// low..high in steps of 10^-digits, times 10^exponent.
  std::string number(int low, int high, int exponent = 0) {
    static constexpr int digits = 3;
    const long steps = between(low * 1000, high * 1000);
    return fmt::format("{}e{}", steps, exponent - digits);
  }
  std::string triple(int x, int y, int low_z, int high_z, int exponent = 0) {
    return fmt::format("({}, {}, {})", number(-x, x, exponent), number(-y, y, exponent),
                       number(low_z, high_z, exponent));
  }
  std::string whole_triple(int size, int low_z, int high_z) {
    return fmt::format("({}, {}, {})", between(-size, size), between(-size, size),
                       between(low_z, high_z));
  }

 private:
  std::uint64_t state_;
};

}  // namespace fos::certified
