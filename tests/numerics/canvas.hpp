// What a rung renders into: what is seen at every pixel, rows from the top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fos::numerics {

template <class T>
struct Canvas {
  int width;
  int height;
  std::vector<std::int32_t> sphere;  ///< its number in the file from 1; 0 is the background
  std::vector<T> I;                  ///< of any value where the background is seen

  Canvas(int w, int h)
      : width(w),
        height(h),
        sphere(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
        I(sphere.size()) {}

  std::size_t size() const { return sphere.size(); }
};

}  // namespace fos::numerics
