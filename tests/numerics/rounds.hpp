// Rungs measured against each other, in rounds: each rung once a round, beginning with another one
// each time, so that what slows the machine down for a while slows all of them.
#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "rung.hpp"
#include "statistics.hpp"

namespace fos::numerics {

/// What a rung took in each round: nanoseconds a pixel, of processor time, its own and that
/// elsewhere: what else runs on the machine does not lengthen it.
using Times = std::vector<double>;

struct Pace {
  int rounds = 15;                      ///< at most
  int at_least = 3;                     ///< whatever they take
  std::chrono::milliseconds budget{0};  ///< no round begins after it; 0 for none
  /// Short frames are rendered as often as this takes, so that the clock's own steps do not count.
  std::chrono::milliseconds shortest{20};
};

/// Times by rung. `on_rung` hears the share that is done, 0..1.
std::vector<Times> measure(const std::vector<Rung>& rungs, std::size_t pixels, const Pace& pace,
                           const std::function<void(double done)>& on_rung);

}  // namespace fos::numerics
