// Writes zips for tests, also such as no tool writes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fos::grading {

/// One file of a zip. What is not given is as an honest tool would have it.
struct TestEntry {
  std::string name;     ///< raw bytes
  std::string content;  ///< before the zeros
  std::uint64_t zeros = 0;
  bool deflated = true;
  std::uint32_t mode = 0100644;             ///< of Unix; 0: from Windows
  std::uint16_t flags = 0;                  ///< 1: encrypted, 0x800: the name is UTF-8
  std::uint16_t method = 0xFFFF;            ///< claimed, if not 0xFFFF
  std::uint32_t claimed_size = UINT32_MAX;  ///< unpacked, if not the greatest
};

/// The bytes of a zip.
std::string zip_of(const std::vector<TestEntry>& entries);

}  // namespace fos::grading
