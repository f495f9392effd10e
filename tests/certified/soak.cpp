// certified_soak FIRST COUNT [SIZE]: random scenes from number FIRST on, each by its own plan and a
// set of terms that its number chooses, against the interval tracer. Two threads. At the first
// wrong byte or bound it stops, with exit status 1.
#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "compare.hpp"
#include "oracle.hpp"
#include "random_scene.hpp"

namespace {

using namespace fos;

struct Sum {
  long scenes = 0;
  std::atomic<long> unsound = 0;
  long undecided = 0;  ///< a color too near to the middle between two bytes, for the oracle too
  certified::Effort effort;
  double closest_claim = 0;
};

constexpr reference::Terms stage_terms[] = {
    reference::flat, reference::ambient, reference::ambient | reference::point,
    reference::ambient | reference::directional,
    reference::ambient | reference::point | reference::directional};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: certified_soak FIRST COUNT [SIZE]\n");
    return 2;
  }
  const long first = std::atol(argv[1]);
  const long end = first + std::atol(argv[2]);
  const int size = argc > 3 ? std::atoi(argv[3]) : 32;
  std::atomic<long> next = first;
  std::mutex mutex;
  Sum sum;
  const auto work = [&] {
    for (long number = next++; number < end && sum.unsound == 0; number = next++) {
      const auto seed = static_cast<std::uint64_t>(number);
      const SceneText scene =
          parse_scene_text(certified::random_scene(seed, size), fmt::format("scene {}", number));
      certified::Comparison result;
      bool undecided = false;
      try {
        // Most have all the light; each has its turn.
        const std::size_t terms = number % 3 != 0 ? 4 : static_cast<std::size_t>(number / 3) % 5;
        result = certified::compare(scene, stage_terms[terms]);
      } catch (const reference::UndecidedError&) {
        undecided = true;
      }
      const std::lock_guard lock(mutex);
      ++sum.scenes;
      sum.undecided += undecided ? 1 : 0;
      sum.effort.in_float += result.effort.in_float;
      sum.effort.in_double += result.effort.in_double;
      sum.effort.exact += result.effort.exact;
      sum.closest_claim = std::max(sum.closest_claim, result.closest_claim);
      if (!result.is_sound()) {
        ++sum.unsound;
        fmt::print("scene {}: {}\n{}\n", number, result.first, scene.source);
      }
    }
  };
  std::thread other(work);
  work();
  other.join();
  const auto pixels =
      static_cast<double>(sum.effort.in_float + sum.effort.in_double + sum.effort.exact);
  fmt::print(
      "{} scenes, {} unsound, {} undecided; of {:.0f} pixels {:.3f} % by floats, {:.3f} % by "
      "doubles, "
      "{:.4f} % exactly; errors of I reach {:.2f} of their bound\n",
      sum.scenes, sum.unsound.load(), sum.undecided, pixels,
      100 * static_cast<double>(sum.effort.in_float) / pixels,
      100 * static_cast<double>(sum.effort.in_double) / pixels,
      100 * static_cast<double>(sum.effort.exact) / pixels, sum.closest_claim);
  return sum.unsound == 0 ? 0 : 1;
}
