#include "hardware_scene.hpp"

#include <limits>
#include <optional>

namespace fos::certified {
namespace {

template <class Real>
using Roots = reference::PossibleRoots<HardwareInterval<Real>>;

/// A t such that a root is surely seen, and not beyond it, unless something nearer hides it.
template <class Real>
std::optional<Real> sure_t(const Roots<Real>& roots) {
  if (!roots.sure) return std::nullopt;
  if (roots.near.is_at_least(1)) return roots.near.high();
  if (roots.near.is_below(1) && roots.far.is_at_least(1)) return roots.far.high();
  return std::nullopt;
}

}  // namespace

template <class Real>
HardwareScene<Real> hardware_scene(const reference::ExactScene& scene) {
  return HardwareScene<Real>(scene, HardwareInterval<Real>::digits);
}

template <class Real>
HardwarePossible<Real> possible(const HardwareScene<Real>& scene, int column, int row,
                                std::span<const int> some) {
  return scene.possible(scene.direction(column, row), some);
}

template <class Real>
std::vector<int> mattering(const HardwareScene<Real>& scene, const Block& block,
                           std::span<const int> some) {
  // Directions grow with the column, and fall with the row, and so do their rounded ends.
  const auto first = scene.direction(block.first_column, block.first_row);
  const auto last = scene.direction(block.end_column - 1, block.end_row - 1);
  const reference::RoundedRay<HardwareInterval<Real>> ray(
      {hull(first[0], last[0]), hull(first[1], last[1]), first[2]});

  std::vector<int> seen;
  std::vector<Real> nearest;  // of each of them: no root is nearer
  Real hidden_beyond = std::numeric_limits<Real>::infinity();
  for (const int i : some) {
    const auto roots = possible_roots(scene.spheres()[static_cast<std::size_t>(i)].rounded, ray);
    if (!roots || (roots->near.is_below(1) && roots->far.is_below(1))) continue;
    seen.push_back(i);
    nearest.push_back(std::min(roots->near.low(), roots->far.low()));
    hidden_beyond = std::min(hidden_beyond, sure_t(*roots).value_or(hidden_beyond));
  }
  std::vector<int> result;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (nearest[i] <= hidden_beyond) result.push_back(seen[i]);
  }
  return result;
}

template HardwareScene<float> hardware_scene(const reference::ExactScene&);
template HardwareScene<double> hardware_scene(const reference::ExactScene&);
template HardwarePossible<float> possible(const HardwareScene<float>&, int, int,
                                          std::span<const int>);
template HardwarePossible<double> possible(const HardwareScene<double>&, int, int,
                                           std::span<const int>);
template std::vector<int> mattering(const HardwareScene<float>&, const Block&,
                                    std::span<const int>);
template std::vector<int> mattering(const HardwareScene<double>&, const Block&,
                                    std::span<const int>);

}  // namespace fos::certified
