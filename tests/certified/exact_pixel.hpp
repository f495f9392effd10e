// One pixel, exactly: the oracle's own search and enclosures, narrowed until they decide.
#pragma once

#include <array>
#include <cstdint>

#include "certified_light.hpp"
#include "exact_scene.hpp"
#include "stage_terms.hpp"

namespace fos::certified {

struct ExactPixel {
  int sphere = 0;                ///< its number in the file from 1; 0 is the background
  reference::Enclosure I{1, 1};  ///< 1 for the background
  std::array<std::uint8_t, 3> bytes{};
};

/// The bytes of color * I.
std::array<std::uint8_t, 3> to_bytes(const reference::Triple<mpq_class>& color, const mpq_class& I);

/// With I known to 2^-`bits` of itself at least. Throws reference::UndecidedError.
ExactPixel exact_pixel(const reference::ExactScene& scene, reference::Terms terms, int column,
                       int row, int bits = 0);

}  // namespace fos::certified
