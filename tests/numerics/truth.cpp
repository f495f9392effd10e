#include "truth.hpp"

#include <mpfr.h>

#include <algorithm>
#include <exception>
#include <thread>

#include "exact_pixel.hpp"
#include "fos/stage_list.hpp"
#include "stage_terms.hpp"

namespace fos::numerics {
namespace {

using namespace reference;

Wide to_wide(const mpq_class& exact) {
  mpfr_t value;
  mpfr_init2(value, 160);
  mpfr_set_q(value, exact.get_mpq_t(), MPFR_RNDN);
  const long double high = mpfr_get_ld(value, MPFR_RNDN);
  mpfr_t rounded;
  mpfr_init2(rounded, 160);
  mpfr_set_ld(rounded, high, MPFR_RNDN);
  mpfr_sub(value, value, rounded, MPFR_RNDN);
  const Wide wide{high, mpfr_get_ld(value, MPFR_RNDN)};
  mpfr_clear(value);
  mpfr_clear(rounded);
  return wide;
}

TruePixel true_pixel(const ExactScene& scene, int column, int row) {
  constexpr Terms all_light = ambient | point | directional;
  constexpr int bits = 90;
  const certified::ExactPixel exact = certified::exact_pixel(scene, all_light, column, row, bits);
  return {exact.sphere, to_wide((exact.I.low + exact.I.high) / 2), exact.bytes};
}

}  // namespace

Truth truth_of(const SceneText& text, const std::function<void(int rows)>& on_rows) {
  const ExactScene scene = reference::to_exact(text);
  Truth truth{text.canvas_width, text.canvas_height, {}};
  truth.pixels.resize(static_cast<std::size_t>(truth.width) *
                      static_cast<std::size_t>(truth.height));
  std::array<std::exception_ptr, 2> failures;
  const auto every_other_row = [&](int first) {
    try {
      auto pixel = truth.pixels.begin() + static_cast<std::ptrdiff_t>(first) * truth.width;
      for (int row = first; row < truth.height; row += 2) {
        for (int column = 0; column < truth.width; ++column) {
          *pixel++ = true_pixel(scene, column, row);
        }
        if (first == 0) on_rows(row + 1);
        if (row + 2 < truth.height) pixel += truth.width;
      }
    } catch (...) {
      failures[static_cast<std::size_t>(first)] = std::current_exception();
    }
  };
  std::thread other(every_other_row, 1);
  every_other_row(0);
  other.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return truth;
}

SceneText as_seen_by(const SceneText& text, unsigned terms) {
  SceneText scene = text;
  std::erase_if(scene.lights, [&](const LightText& light) {
    const unsigned term = light.kind == LightKind::ambient ? ambient_term
                          : light.kind == LightKind::point ? point_term
                                                           : directional_term;
    return (terms & term) == 0;
  });
  if (terms == 0) scene.lights.push_back({LightKind::ambient, parse_decimal("1"), {}, {}});
  return scene;
}

}  // namespace fos::numerics
