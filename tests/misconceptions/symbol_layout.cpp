#include "symbol_layout.hpp"

#include <algorithm>

namespace fos {

SymbolLayout::SymbolLayout(const std::vector<SceneText>& scenes,
                           const std::vector<std::uint16_t>* spheres)
    : spheres_(spheres) {
  for (const SceneText& scene : scenes) {
    for (int row = 0; row < scene.canvas_height; ++row) {
      for (int column = 0; column < scene.canvas_width; ++column) {
        pixels_.push_back({static_cast<std::size_t>(scene.canvas_width), column > 0, row > 0});
      }
    }
  }
}

std::uint16_t SymbolLayout::predict(const Symbols& symbols, std::size_t i) const {
  const Place& place = pixels_[i];
  const bool has_left = place.has_left && has_symbol(i - 1);
  const bool has_above = place.has_above && has_symbol(i - place.width);
  if (!has_left && !has_above) return 0;
  if (!has_above) return symbols[i - 1];
  const int above = symbols[i - place.width];
  if (!has_left) return static_cast<std::uint16_t>(above);
  const int left = symbols[i - 1];
  const int corner = has_symbol(i - place.width - 1) ? symbols[i - place.width - 1] : above;
  const auto [least, most] = std::minmax(left, above);
  return static_cast<std::uint16_t>(std::clamp(left + above - corner, least, most));
}

}  // namespace fos
