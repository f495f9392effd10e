// What a result depends on, in one word.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hand_in.hpp"

namespace fos::grading {

/// The same for the same files (or reasons why there are none), seed, toolkit and settings, and
/// different otherwise: SHA-256, in hexadecimal digits. Names and notes have no part in it, so a
/// roster changes no result. `settings` is any text that says what else the grading depends on.
std::string result_key(const HandIn& hand_in, std::uint64_t seed, std::string_view toolkit,
                       std::string_view settings);

}  // namespace fos::grading
