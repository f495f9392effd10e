#include "digest.hpp"

#include <sys/types.h>

// libmd's header counts on sys/types.h before it.
#include <sha256.h>

#include <array>

namespace fos::grading {

std::string sha256(std::string_view bytes) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digits.data());
  return digits.data();
}

}  // namespace fos::grading
