#include "compare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "exact_pixel.hpp"

namespace fos::certified {
namespace {

constexpr int bits_of_I = 60;

/// How much of `error` the claimed I is off.
double share_of_bound(float I, float error, const reference::Enclosure& exact) {
  const mpq_class off = abs(mpq_class(I) - (exact.low + exact.high) / 2);
  return off == 0 ? 0 : mpq_class(off / mpq_class(error)).get_d();
}

}  // namespace

Comparison compare(const SceneText& scene, reference::Terms terms, bool by_general_plan) {
  const reference::ExactScene exact_scene = reference::to_exact(scene);
  Renderer renderer(scene, terms);
  if (by_general_plan) renderer = Renderer(scene, terms, general_plan(renderer.scene()));
  Picture picture;
  Claims claims;
  Comparison result;
  result.effort = renderer.render(picture, &claims);
  std::size_t pixel = 0;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column, ++pixel) {
      const ExactPixel exact = exact_pixel(exact_scene, terms, column, row, bits_of_I);
      long wrong = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        wrong += picture.rgb[3 * pixel + i] != exact.bytes[i] ? 1 : 0;
      }
      const float error = claims.error[pixel];
      const double share = error > 0 && error < 1 && exact.sphere != 0
                               ? share_of_bound(claims.I[pixel], error, exact.I)
                               : 0;
      result.wrong_bytes += wrong;
      result.broken_claims += share > 1 ? 1 : 0;
      result.closest_claim = std::max(result.closest_claim, share);
      if ((wrong > 0 || share > 1) && result.first.empty()) {
        result.first = fmt::format("column {}, row {}: {} wrong bytes, I off by {} of its bound",
                                   column, row, wrong, share);
      }
    }
  }
  return result;
}

}  // namespace fos::certified
