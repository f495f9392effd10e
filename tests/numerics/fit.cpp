#include "fit.hpp"

#include <algorithm>
#include <chrono>

#include "truth.hpp"

namespace fos::numerics {
namespace {

// Under a minute in all, on a machine that may be twice as busy later as it is now.
constexpr double seconds_for_truth = 18;
constexpr double largest_canvas = 1'000'000;  // pixels: each rung keeps its own picture in memory

double pixels_of(const SceneText& scene) {
  return static_cast<double>(scene.canvas_width) * scene.canvas_height;
}

/// The scene on a canvas of about so many pixels, or its own if that is smaller.
SceneText sample(const SceneText& scene, double pixels) {
  int factor = 1;
  while (pixels_of(made_smaller(scene, factor)) > pixels) ++factor;
  return made_smaller(scene, factor);
}

}  // namespace

SceneText made_smaller(const SceneText& scene, int factor) {
  SceneText smaller = scene;
  smaller.canvas_width = (scene.canvas_width + factor - 1) / factor;
  smaller.canvas_height = (scene.canvas_height + factor - 1) / factor;
  return smaller;
}

Fit fit(const SceneText& scene, const Cost& cost) {
  for (int factor = 1;; ++factor) {
    const double pixels = pixels_of(made_smaller(scene, factor));
    const Fit fit{factor, pixels * cost.truth, pixels * cost.round};
    const bool fits = fit.truth_seconds <= seconds_for_truth &&
                      fit.round_seconds * rounds_aimed_at <= seconds_for_rounds &&
                      pixels <= largest_canvas;
    if (fits || pixels == 1) return fit;
  }
}

Cost cost_of(const SceneText& scene,
             const std::function<std::vector<Rung>(const SceneText&)>& rungs_of) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto begin = Clock::now();
  Cost cost;
  Cost before;  // of a smaller canvas, in all
  double pixels_before = 0;
  // A few pixels, and more while they are quick. What does not grow with the canvas, starting
  // programs say, drops out in the difference of the last two.
  for (const double about : {25.0, 400.0, 6400.0}) {
    const SceneText small = sample(scene, about);
    const double pixels = pixels_of(small);
    if (pixels == pixels_before) break;
    auto start = Clock::now();
    truth_of(small);
    Cost all{seconds_since(start), 0};
    const std::vector<Rung> rungs = rungs_of(small);
    for (const Rung& rung : rungs) rung.render();
    start = Clock::now();
    for (const Rung& rung : rungs) rung.render();
    all.round = seconds_since(start);
    const auto slope = [&](double Cost::*which) {
      return std::max(all.*which - before.*which, 0.1 * all.*which) / (pixels - pixels_before);
    };
    cost = {slope(&Cost::truth), slope(&Cost::round)};
    before = all;
    pixels_before = pixels;
    if (seconds_since(begin) > 1) break;
  }
  return cost;
}

}  // namespace fos::numerics
