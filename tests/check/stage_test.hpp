// What a stage must do, thing by thing, and what helps on the way. stages/STAGE_test.cpp defines it
// for one stage; `./lab check`, the Catch2 tests and the grader all ask from here.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fos/stage_list.hpp"
#include "pixel.hpp"

namespace fos {

/// A pixel whose answer is worked out by hand.
struct PixelCase {
  std::string scene;    ///< a scene file's text; empty for the lecture's scene
  Pixel pixel;          ///< on the scene's own canvas
  Channels expected{};  ///< right within 0.01, both cut off at 255: wide enough for float, and
                        ///< far below the half of a byte that could hide a mistake
};

/// One thing that a stage must do. It does it when every pixel is right.
struct Check {
  Text words;
  std::vector<PixelCase> pixels;
};

struct StageTest {
  /// In the order to be told. After them every pixel of the scenes that labs/stages.json lists for
  /// the stage is checked.
  std::vector<Check> checks;
  std::vector<Text> hints;  ///< a ladder, from a question to the formula
};

/// Of a stage by its id; throws std::out_of_range where there is none.
const StageTest& stage_test(std::string_view id);

/// The pixel straight ahead of the camera, x = 0 and y = 0, in a scene of these spheres and lights
/// before a black background.
PixelCase ahead(const Channels& expected, std::string_view spheres_and_lights);

/// The same with a sphere of color (200, 100, 50) and these lights: it is met at P = (0, 0, 2),
/// where N = (0, 0, -1).
PixelCase lit(const Channels& expected, std::string_view lights);

/// A pixel of the lecture's scene, 600 x 600.
PixelCase lecture_pixel(int column, int row, const Channels& expected);

}  // namespace fos
