// reference_bench SCENE…: what a pixel's reference costs by reference::generate and by
// certified::reference, and whether they are equal. Exit status 1 if they are not. The times are
// those of the processor, of both threads together: others may use it too.
#include <fmt/core.h>

#include <ctime>
#include <utility>

#include "fast_reference.hpp"
#include "generate.hpp"

namespace {

constexpr int fast_runs = 5;  // the time of one is too short to measure

/// What `make` makes, and its microseconds, the mean of some runs.
template <class Make>
auto timed(int runs, const Make& make) {
  const std::clock_t start = std::clock();
  auto result = make();
  for (int run = 1; run < runs; ++run) result = make();
  const double time = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return std::pair(std::move(result), time / runs);
}

}  // namespace

int main(int argc, char** argv) {
  bool all_equal = true;
  for (int i = 1; i < argc; ++i) {
    const fos::SceneText scene = fos::read_scene_text(argv[i]);
    const double pixels = 1.0 * scene.canvas_width * scene.canvas_height;
    fos::certified::ReferenceEffort effort;
    const auto [fast, fast_time] =
        timed(fast_runs, [&] { return fos::certified::reference(scene, &effort); });
    const auto [slow, slow_time] = timed(1, [&] { return fos::reference::generate(scene); });
    all_equal = all_equal && fast == slow;
    fmt::print(
        "{}: {} x {} pixels\n"
        "  generate   {:8.2f} us a pixel, {:.3f} s\n"
        "  reference  {:8.2f} us a pixel, {:.3f} s: {:.1f} times faster, {}\n"
        "  {} pixels left to the oracle, {} of them also for what may be seen\n",
        argv[i], scene.canvas_width, scene.canvas_height, slow_time / pixels, slow_time / 1e6,
        fast_time / pixels, fast_time / 1e6, slow_time / fast_time,
        fast == slow ? "equal" : "NOT EQUAL", effort.by_oracle.load() / fast_runs,
        effort.with_mpfi.load() / fast_runs);
  }
  return all_equal ? 0 : 1;
}
