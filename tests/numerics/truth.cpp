#include "truth.hpp"

#include <mpfr.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <thread>

#include "certified_light.hpp"
#include "exact_hit.hpp"
#include "fos/stage_list.hpp"
#include "oracle.hpp"
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

std::array<std::uint8_t, 3> to_bytes(const Triple<mpq_class>& color, const mpq_class& I) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    bytes[i] = static_cast<std::uint8_t>(reference::to_byte(color[i] * I));
  }
  return bytes;
}

TruePixel true_pixel(const ExactScene& scene, int column, int row) {
  const Triple<mpq_class> D = exact_direction(scene, column, row);
  const std::optional<ExactHit> hit = exact_hit(scene, D);
  if (!hit) return {0, {1, 0}, to_bytes(scene.background_color, 1)};
  const Triple<mpq_class>& color = scene.spheres[static_cast<std::size_t>(hit->sphere)].color;
  for (const mpfr_prec_t bits : {128, 256, 512, 1024, 2048}) {
    const auto terms = certified_terms(scene, D, *hit, bits);
    if (!terms) continue;
    const TermSums sums = sum_terms(scene, *terms);
    const mpq_class low = scene.ambient + sums.point.low + sums.directional.low;
    const mpq_class high = scene.ambient + sums.point.high + sums.directional.high;
    const auto bytes = to_bytes(color, low);
    if (high - low > high * mpq_class(1, mpz_class(1) << 90)) continue;
    if (bytes == to_bytes(color, high)) return {hit->sphere + 1, to_wide((low + high) / 2), bytes};
  }
  throw UndecidedError("column " + std::to_string(column) + ", row " + std::to_string(row));
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
