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

int SymbolLayout::predict(const std::vector<int>& numbers, std::size_t i) const {
  const Place& place = pixels_[i];
  const bool has_left = place.has_left && has_symbol(i - 1);
  const bool has_above = place.has_above && has_symbol(i - place.width);
  if (!has_left && !has_above) return 0;
  if (!has_above) return numbers[i - 1];
  const int above = numbers[i - place.width];
  if (!has_left) return above;
  const int left = numbers[i - 1];
  const int corner = has_symbol(i - place.width - 1) ? numbers[i - place.width - 1] : above;
  const auto [least, most] = std::minmax(left, above);
  return std::clamp(left + above - corner, least, most);
}

}  // namespace fos
