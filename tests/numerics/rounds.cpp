#include "rounds.hpp"

#include <algorithm>
#include <cmath>

namespace fos::numerics {
namespace {

using Clock = std::chrono::steady_clock;
using Nanoseconds = std::chrono::duration<double, std::nano>;

double time_of(const Rung& rung, int frames) {
  const auto start = Clock::now();
  for (int i = 0; i < frames; ++i) rung.render();
  return Nanoseconds(Clock::now() - start).count() / frames;
}

}  // namespace

std::vector<Times> measure(const std::vector<Rung>& rungs, std::size_t pixels, const Pace& pace,
                           const std::function<void(double done)>& on_rung) {
  const auto start = Clock::now();
  const OneProcessor here;
  // The first frame is not counted: it brings memory and code into the caches.
  std::vector<int> frames;
  for (const Rung& rung : rungs) {
    const double once = std::max(time_of(rung, 1), 1.0);
    frames.push_back(static_cast<int>(std::ceil(Nanoseconds(pace.shortest).count() / once)));
  }

  const std::size_t count = rungs.size();
  std::vector<Times> times(count);
  for (int round = 0; round < pace.rounds; ++round) {
    const bool late = pace.budget.count() > 0 && Clock::now() - start > pace.budget;
    if (round >= pace.at_least && late) break;
    for (std::size_t turn = 0; turn < count; ++turn) {
      const std::size_t i = (turn + static_cast<std::size_t>(round)) % count;
      times[i].push_back(time_of(rungs[i], frames[i]) / static_cast<double>(pixels));
      const auto done = static_cast<double>(static_cast<std::size_t>(round) * count + turn + 1);
      on_rung(done / static_cast<double>(count * static_cast<std::size_t>(pace.rounds)));
    }
  }

  const std::vector<Times> gross = times;
  for (std::size_t i = 0; i < count; ++i) {
    if (!rungs[i].toll) continue;
    const Times& toll = gross[*rungs[i].toll];
    for (std::size_t round = 0; round < times[i].size(); ++round) {
      // Never less than a tenth of a nanosecond: what costs nothing has no place on the plot.
      times[i][round] = std::max(times[i][round] - toll[round], 0.1);
    }
  }
  return times;
}

OneProcessor::OneProcessor() {
  const int here = sched_getcpu();
  if (here < 0 || sched_getaffinity(0, sizeof(before_), &before_) != 0) return;
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(here, &only);
  set_ = sched_setaffinity(0, sizeof(only), &only) == 0;
}

OneProcessor::~OneProcessor() {
  if (set_) sched_setaffinity(0, sizeof(before_), &before_);
}

}  // namespace fos::numerics
