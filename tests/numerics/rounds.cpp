#include "rounds.hpp"

#include <sched.h>

#include <algorithm>
#include <ctime>

namespace fos::numerics {
namespace {

using Clock = std::chrono::steady_clock;
using Nanoseconds = std::chrono::duration<double, std::nano>;

/// Processor time that went into the rung so far, in nanoseconds.
double processor_time(const Rung& rung) {
  timespec own{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &own);
  return 1e9 * static_cast<double>(own.tv_sec) + static_cast<double>(own.tv_nsec) +
         rung.elsewhere();
}

double time_of(const Rung& rung, int frames) {
  const double start = processor_time(rung);
  for (int i = 0; i < frames; ++i) rung.render();
  return (processor_time(rung) - start) / frames;
}

/// Keeps this thread, and the programs that it starts meanwhile, on one processor, and none of them
/// interrupts another: so a program fills its pipe before its asker empties it, whether a row takes
/// it long or not, and the changes between the two cost the same.
class OneProcessor {
 public:
  OneProcessor() {
    sched_getaffinity(0, sizeof(before_), &before_);
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(static_cast<std::size_t>(std::max(sched_getcpu(), 0)), &only);
    // Where it may not be, the times of programs are only less steady.
    sched_setaffinity(0, sizeof(only), &only);
    const sched_param none{};
    sched_setscheduler(0, SCHED_BATCH, &none);
  }
  ~OneProcessor() {
    const sched_param none{};
    sched_setscheduler(0, SCHED_OTHER, &none);
    sched_setaffinity(0, sizeof(before_), &before_);
  }
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  cpu_set_t before_{};
};

}  // namespace

std::vector<Times> measure(const std::vector<Rung>& rungs, std::size_t pixels, const Pace& pace,
                           const std::function<void(double done)>& on_rung) {
  const auto start = Clock::now();
  const OneProcessor here;
  // The first frame is not counted: it brings memory and code into the caches, and starts programs.
  std::vector<int> frames;
  for (const Rung& rung : rungs) {
    rung.render();
    const double once = std::max(time_of(rung, 1), 1.0);
    frames.push_back(std::max(1, static_cast<int>(Nanoseconds(pace.shortest).count() / once)));
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

}  // namespace fos::numerics
