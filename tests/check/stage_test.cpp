#include "stage_test.hpp"

#include <fmt/core.h>

#include <map>

namespace fos {

#define FOS_STAGE(id) StageTest id##_test();  // stages/ID_test.cpp
#include "fos/each_stage.inc"
#undef FOS_STAGE

const StageTest& stage_test(std::string_view id) {
  static const std::map<std::string, StageTest> tests{
#define FOS_STAGE(id) {#id, id##_test()},
#include "fos/each_stage.inc"
#undef FOS_STAGE
  };
  return tests.at(std::string(id));
}

PixelCase ahead(const Channels& expected, std::string_view spheres_and_lights) {
  // x = column - 1, y = -row: column 1, row 0 looks straight along +z.
  return {fmt::format("canvas_size = 2 x 2\nbackground_color = (0, 0, 0)\n{}", spheres_and_lights),
          {1, 0},
          expected};
}

PixelCase lit(const Channels& expected, std::string_view lights) {
  return ahead(
      expected,
      fmt::format("sphere {{ center = (0, 0, 3)  radius = 1  color = (200, 100, 50) }}\n{}",
                  lights));
}

PixelCase lecture_pixel(int column, int row, const Channels& expected) {
  return {"", {column, row}, expected};
}

}  // namespace fos
