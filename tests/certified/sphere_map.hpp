// Which spheres can matter where, found once for all pixels: blocks of pixels are divided in four
// as long as that may leave spheres out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardware_scene.hpp"

namespace fos::certified {

class SphereMap {
 public:
  static constexpr int tile_size = 4;  ///< pixels, in each direction

  /// For what a program may see at Real's precision, or at a higher one.
  template <class Real>
  SphereMap(const HardwareScene<Real>& scene, int width, int height);

  /// Indices of the scene's spheres(), rising.
  std::span<const int> at(int column, int row) const {
    const Tile& tile = tiles_[index(column, row)];
    return std::span(spheres_).subspan(tile.first, tile.count);
  }

 private:
  struct Tile {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  template <class Real>
  void fill(const HardwareScene<Real>& scene, const Block& block, std::span<const int> some);

  /// Of the tile that holds a pixel.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row / tile_size) * tiles_across_ +
           static_cast<std::size_t>(column / tile_size);
  }

  std::size_t tiles_across_;
  std::vector<Tile> tiles_;
  std::vector<int> spheres_;  ///< those of all tiles, one tile after the other
};

}  // namespace fos::certified
