// What the Catch2 tests of the stages have in common: they ask the program that FOS_PROGRAM names,
// a lab, its solution, or a variation of it, and judge its pixels.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "catch2.hpp"
#include "fos/stage_list.hpp"

namespace fos {

/// A pixel's channels, 0..255 and not rounded.
using Channels = std::array<double, 3>;

/// The channels of one pixel of a scene. Fails the test where there is no frame, or where the pixel
/// is unwritten or not finite.
Channels pixel_of(std::string_view scene_text, int column, int row);

/// The pixel straight ahead of the camera, x = 0 and y = 0, in a scene of these spheres and lights,
/// before a black background.
Channels pixel_ahead(std::string_view spheres_and_lights);

/// The same with a sphere of color (200, 100, 50) and these lights: it is met at P = (0, 0, 2),
/// where N = (0, 0, -1).
Channels lit(std::string_view lights);

/// Fails the test where `actual` is not within 0.01 of `expected`, both cut off at 255: wide enough
/// for float, and far below the half of a byte that could hide a mistake.
void check_channels(const Channels& actual, const Channels& expected);

/// A pixel of the lecture's scene, on its own canvas of 600 x 600.
Channels lecture_pixel(int column, int row);

/// Every pixel of every scene that labs/stages.json lists for the stage.
void check_whole_frames(std::string_view stage_id);

}  // namespace fos
