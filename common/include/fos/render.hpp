// The camera and the loop over the pixels.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fos/scene.hpp"

namespace fos {

/// The camera looks along +z, y up. The canvas lies on the viewport, which is `projection_plane_d`
/// in front of it.
struct View {
  int canvas_width = 600;  ///< pixels, 1..16384
  int canvas_height = 600;
  Real viewport_width = 1;  ///< > 0
  Real viewport_height = 1;
  Real projection_plane_d = 1;  ///< > 0
  Vec3 camera_position{0};
};

/// D for the pixel in `column` (0 is left) and `row` (0 is the top): the ray goes through the
/// pixel's corner, x = column − W/2, y = H/2 − 1 − row, with W/2 a real number for odd W too
/// (Gambetta, "Computer Graphics from Scratch", ch. 2, as his published pictures have it).
Vec3 canvas_to_viewport(const View& view, int column, int row);

/// One row of the picture, from the left: a color a pixel, and 1 where unwritten() was called.
using RowSink =
    std::function<void(std::span<const Color> colors, std::span<const std::uint8_t> unwritten)>;

/// The row that is being made: for the one who must say at which pixel it ended.
struct RowInTheMaking {
  std::vector<Color> colors;
  std::atomic<int> pixels{0};  ///< done, from the left; 0 also between two rows
};

/// Calls trace_ray for each pixel and hands each row to `sink` as soon as it is made.
void render(const Scene& scene, const View& view, const RowSink& sink, RowInTheMaking& making);
void render(const Scene& scene, const View& view, const RowSink& sink);

}  // namespace fos
