#include "sphere_map.hpp"

#include <algorithm>
#include <numeric>

namespace fos::certified {
namespace {

/// Half of a block's tiles.
int middle(int first, int end, int tile_size) {
  const int tiles = (end - first + tile_size - 1) / tile_size;
  return first + (tiles + 1) / 2 * tile_size;
}

}  // namespace

template <class Real>
SphereMap::SphereMap(const HardwareScene<Real>& scene, int width, int height)
    : tiles_across_((width + tile_size - 1) / tile_size) {
  const int tiles_down = (height + tile_size - 1) / tile_size;
  tiles_.resize(static_cast<std::size_t>(tiles_across_) * static_cast<std::size_t>(tiles_down));
  std::vector<int> all(scene.spheres().size());
  std::iota(all.begin(), all.end(), 0);
  const RoundUp upward;
  fill(scene, {0, 0, width, height}, all);
}

template <class Real>
void SphereMap::fill(const HardwareScene<Real>& scene, const Block& block,
                     std::span<const int> some) {
  if (some.empty() || block.first_column >= block.end_column || block.first_row >= block.end_row) {
    return;
  }
  RoundUp::start();
  std::vector<int> left = mattering(scene, block, some);
  if (!RoundUp::is_in_range()) left.assign(some.begin(), some.end());

  const int column = middle(block.first_column, block.end_column, tile_size);
  const int row = middle(block.first_row, block.end_row, tile_size);
  if (column >= block.end_column && row >= block.end_row) {  // one tile
    tiles_[static_cast<std::size_t>(block.first_row / tile_size * tiles_across_ +
                                    block.first_column / tile_size)] = {
        static_cast<std::uint32_t>(spheres_.size()), static_cast<std::uint32_t>(left.size())};
    spheres_.insert(spheres_.end(), left.begin(), left.end());
    return;
  }
  const int end_left = std::min(column, block.end_column);
  const int end_top = std::min(row, block.end_row);
  fill(scene, {block.first_column, block.first_row, end_left, end_top}, left);
  fill(scene, {end_left, block.first_row, block.end_column, end_top}, left);
  fill(scene, {block.first_column, end_top, end_left, block.end_row}, left);
  fill(scene, {end_left, end_top, block.end_column, block.end_row}, left);
}

template SphereMap::SphereMap(const HardwareScene<float>&, int, int);
template SphereMap::SphereMap(const HardwareScene<double>&, int, int);

}  // namespace fos::certified
