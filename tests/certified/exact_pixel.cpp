#include "exact_pixel.hpp"

#include <optional>
#include <string>

#include "exact_hit.hpp"
#include "oracle.hpp"

namespace fos::certified {

using reference::Triple;

std::array<std::uint8_t, 3> to_bytes(const Triple<mpq_class>& color, const mpq_class& I) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    bytes[i] = static_cast<std::uint8_t>(reference::to_byte(color[i] * I));
  }
  return bytes;
}

ExactPixel exact_pixel(const reference::ExactScene& scene, reference::Terms terms, int column,
                       int row, int bits) {
  const Triple<mpq_class> D = reference::exact_direction(scene, column, row);
  const std::optional<reference::ExactHit> hit = reference::exact_hit(scene, D);
  if (!hit) return {0, {1, 1}, to_bytes(scene.background_color, 1)};
  const Triple<mpq_class>& color = scene.spheres[static_cast<std::size_t>(hit->sphere)].color;
  const mpq_class narrow(1, mpz_class(1) << static_cast<unsigned>(bits));
  for (const mpfr_prec_t working : {128, 256, 512, 1024, 2048}) {
    const auto enclosures = reference::certified_terms(scene, D, *hit, working);
    if (!enclosures) continue;
    const reference::TermSums sums = reference::sum_terms(scene, *enclosures);
    reference::Enclosure I{
        reference::intensity(terms, scene.ambient, sums.point.low, sums.directional.low),
        reference::intensity(terms, scene.ambient, sums.point.high, sums.directional.high)};
    const auto bytes = to_bytes(color, I.low);
    if (I.high - I.low <= I.high * narrow && bytes == to_bytes(color, I.high)) {
      return {hit->sphere + 1, std::move(I), bytes};
    }
  }
  throw reference::UndecidedError("column " + std::to_string(column) + ", row " +
                                  std::to_string(row) + ": undecided at 2048 bits");
}

}  // namespace fos::certified
