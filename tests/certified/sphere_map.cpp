#include "sphere_map.hpp"

#include <algorithm>
#include <numeric>

namespace fos::certified {
namespace {

/// That cover so many pixels of a row or a column.
int tiles(int pixels) { return (pixels + SphereMap::tile_size - 1) / SphereMap::tile_size; }

/// Where half of a block's tiles end.
int middle(int first, int end) {
  return first + (tiles(end - first) + 1) / 2 * SphereMap::tile_size;
}

}  // namespace

template <class Real>
SphereMap::SphereMap(const HardwareScene<Real>& scene, int width, int height)
    : tiles_across_(static_cast<std::size_t>(tiles(width))),
      tiles_(tiles_across_ * static_cast<std::size_t>(tiles(height))) {
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

  const int column = middle(block.first_column, block.end_column);
  const int row = middle(block.first_row, block.end_row);
  if (column >= block.end_column && row >= block.end_row) {  // one tile
    tiles_[index(block.first_column, block.first_row)] = {
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
