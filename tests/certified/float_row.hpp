// A row of a certified picture, in SIMD floats: every byte that it decides is proven.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "float_lights.hpp"
#include "row_sphere.hpp"

namespace fos::certified {

/// How many bytes, or numbers, behind the end of a row float_row may write.
inline constexpr int row_padding = 3 * 64;

/// What the floats claim of the pixels that they shade: I, and how far it is off at most. Each has
/// room for row_padding more numbers than the row has pixels.
struct RowClaims {
  float* I;
  float* error;
};

/// A pixel that floats leave open: its light only, where the sphere is known.
struct Undecided {
  int column;
  const CameraSphere* sphere;  ///< nullptr: what is seen is open too
};

struct RowTask {
  int width;
  float kx, Y, d;  ///< D = (x kx, Y, d)
  Bytes background;
  bool shade;  ///< false: nothing but the ambient light, so neither P nor N is needed
  const FloatLights* lights;
  std::span<const RowSphere> spheres;  ///< the nearest first
  RowClaims* claims = nullptr;         ///< to be filled in where it is asked for
};

/// Writes the pixels that show a sphere into `rgb`, which holds the background, and appends those
/// that it does not decide to `undecided`.
void float_row(const RowTask& task, std::uint8_t* rgb, std::vector<Undecided>& undecided);

/// The instruction set that float_row uses here: AVX3, AVX2, ...
const char* float_row_target();

}  // namespace fos::certified
