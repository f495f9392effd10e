// What a pixel's channels say of the light I on a surface of a known color.
#pragma once

#include <array>
#include <optional>

#include "light_code.hpp"

namespace fos {

/// Red, green, blue, 0..255.
using Channels = std::array<double, 3>;

/// Whether the channels are the color times some I >= 0, as far as those that are not cut off at
/// 255 show it.
bool is_shade(const Channels& color, const Channels& channels);

/// That I; nothing where it is none, or a channel is cut off.
std::optional<double> light_of(const Channels& color, const Channels& channels);

/// Whether I lies in the cell of a code, or so near that rounding may be why it does not.
bool has_code(double I, LightCode code);

}  // namespace fos
