// N, L and the angle between them at P, in plain characters.
#pragma once

#include <string>
#include <vector>

namespace fos {

/// The plane of N and L with N upward, as lines: at most 9, each at most 80 columns. `words`
/// stand to the right of it, at most two of them. `degrees` is 0..180; beyond 90 the light is
/// behind the surface.
std::vector<std::string> draw_angle(double degrees, const std::vector<std::string>& words);

}  // namespace fos
