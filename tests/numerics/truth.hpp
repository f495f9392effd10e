// What is exactly right at every pixel, to measure errors against: the oracle's own exact search
// and enclosures, with I to more digits than any type measured here has.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "fos/scene_text.hpp"

namespace fos::numerics {

/// A number to about 90 bits: high + low.
struct Wide {
  long double high = 0;
  long double low = 0;
};

/// The exact answer at one pixel.
struct TruePixel {
  int sphere = 0;                       ///< its number in the file from 1; 0 is the background
  Wide I{1, 0};                         ///< I_A and all lights of the scene; 1 for the background
  std::array<std::uint8_t, 3> bytes{};  ///< of color * I, or of the background
};

struct Truth {
  int width = 0;
  int height = 0;
  std::vector<TruePixel> pixels;  ///< rows from the top
};

/// All pixels, in two threads; about 20 microseconds each. `on_rows` hears now and then how many
/// rows are done, from the calling thread. Throws what the oracle throws: std::range_error for
/// numbers beyond 10^±10000, UndecidedError.
Truth truth_of(
    const SceneText& text, const std::function<void(int rows)>& on_rows = [](int) {});

/// The scene as a stage sees it, `terms` as in Stage: without the lights that are no term of its I.
/// Without any term I is 1 (an ambient light of 1 and no other).
SceneText as_seen_by(const SceneText& text, unsigned terms);

}  // namespace fos::numerics
