// The prepared formula on as many pixels of a row at once as a vector register holds numbers.
#pragma once

#include <string>

#include "canvas.hpp"
#include "prepared.hpp"

namespace fos::numerics {

/// By the best instructions that this machine has; which of those that were compiled in is decided
/// at the first call.
void render_simd(const PreparedScene<float>& scene, Canvas<float>& out);
void render_simd(const PreparedScene<double>& scene, Canvas<double>& out);

/// Their name, as `AVX3`.
std::string simd_target();

}  // namespace fos::numerics
