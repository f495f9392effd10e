// What the color of a pixel says of the sphere and of I, for it is color x I.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "asked_pixel.hpp"
#include "fos/scene_text.hpp"

namespace fos {

/// Whose color a pixel may have.
struct Hue {
  bool black = false;        ///< that of anything without light: it says nothing
  bool background = false;   ///< the background's color as it is
  std::vector<int> spheres;  ///< their numbers from 1: the pixel is a multiple of their color

  bool fits(int sphere) const {
    return std::find(spheres.begin(), spheres.end(), sphere) != spheres.end();
  }
};

/// `channels` are finite. Without light (the stage has no terms) only the color itself fits.
/// A channel above 255 fits one that is cut off there; whole numbers fit what they may be
/// rounded from.
Hue hue_of(const LinearChannels& channels, const SceneText& scene, bool with_light);

/// The I of a pixel of this color.
struct SeenI {
  long double value = 0;
  bool at_least = false;  ///< all channels are cut off at white: I may be larger
};

/// From the largest channel that is not cut off; nothing for a black color.
std::optional<SeenI> I_of(const LinearChannels& channels, const DecimalTriple& color);

/// Whether all are whole numbers, and not all 0 or white.
bool are_whole(const LinearChannels& channels);

}  // namespace fos
