// What float and double programs may see, as reference::RoundedScene says it, in intervals of the
// machine. Call all of this while a RoundUp lives; where one finds something out of range, the
// result of the call means nothing.
#pragma once

#include <span>
#include <vector>

#include "hardware_interval.hpp"
#include "rounded_scene.hpp"

namespace fos::certified {

template <class Real>
using HardwareScene = reference::RoundedSceneOf<HardwareInterval<Real>>;
template <class Real>
using HardwarePossible = reference::PossibleOf<HardwareInterval<Real>>;

template <class Real>
HardwareScene<Real> hardware_scene(const reference::ExactScene& scene);

/// `some` are indices of scene.spheres(), rising, among them all that can matter there.
template <class Real>
HardwarePossible<Real> possible(const HardwareScene<Real>& scene, int column, int row,
                                std::span<const int> some);

/// Pixels; the ends are not in it.
struct Block {
  int first_column, first_row;
  int end_column, end_row;
};

/// Which of some spheres can matter in a block: those that a program may see there and that none
/// surely hides all over it. Holds for every higher precision too.
///
/// Each operation's interval holds the intervals that it gives for parts of its operands, and for
/// more bits. So for the rays of all pixels as one interval of directions, what is certain is
/// certain for each ray, and at more bits.
template <class Real>
std::vector<int> mattering(const HardwareScene<Real>& scene, const Block& block,
                           std::span<const int> some);

}  // namespace fos::certified
