#include "certified_frame.hpp"

#include <cstddef>

#include "stored_terms.hpp"

namespace fos::reference {

std::vector<std::uint8_t> certified_frame(const ExactScene& scene, const Reference& reference,
                                          Terms terms) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * reference.pixels.size());
  for (const StoredPixel& pixel : reference.pixels) {
    const bool is_hit = pixel.sphere != 0;
    const mpq_class I =
        is_hit ? intensity(terms, scene.ambient, from_multiple(pixel.point, reference.step),
                           from_multiple(pixel.directional, reference.step))
               : mpq_class(1);
    const Triple<mpq_class>& color =
        is_hit ? scene.spheres[static_cast<std::size_t>(pixel.sphere - 1)].color
               : scene.background_color;
    for (const mpq_class& channel : color) {
      bytes.push_back(static_cast<std::uint8_t>(to_byte(channel * I)));
    }
  }
  return bytes;
}

}  // namespace fos::reference
