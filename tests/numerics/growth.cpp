#include "growth.hpp"

#include <fmt/core.h>

#include <cmath>
#include <ctime>
#include <memory>

#include "certified.hpp"
#include "rounds.hpp"
#include "statistics.hpp"

namespace fos::numerics {
namespace {

constexpr reference::Terms all_light =
    reference::ambient | reference::point | reference::directional;

constexpr const char* lecture_spheres =
    "sphere { center = (0, -1, 3)     radius = 1     color = (255, 0, 0) }\n"
    "sphere { center = (2, 0, 4)      radius = 1     color = (0, 0, 255) }\n"
    "sphere { center = (-2, 0, 4)     radius = 1     color = (0, 255, 0) }\n"
    "sphere { center = (0, -5001, 0)  radius = 5000  color = (255, 255, 0) }\n"
    "light { type = ambient  intensity = 0.2 }\n";

/// Points that fill the unit square evenly, whatever their number (Roberts' R2 sequence).
double spread(int i, double step) { return std::fmod(0.5 + step * i, 1.0); }

double milliseconds_of_processor() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// One scene in the making of a series.
struct Subject {
  long number;
  std::string text;
};

/// The subjects of a series are measured in common rounds, as rungs are.
std::vector<GrowthPoint> measure_series(const std::vector<Subject>& subjects,
                                        const std::function<void(double)>& on_progress) {
  std::vector<GrowthPoint> points;
  std::vector<Rung> rungs;
  for (const Subject& subject : subjects) {
    const SceneText scene = parse_scene_text(subject.text, "growth");
    const double start = milliseconds_of_processor();
    const auto renderer = std::make_shared<certified::Renderer>(scene, all_light);
    const double pixels = static_cast<double>(scene.canvas_width) * scene.canvas_height;
    points.push_back({subject.number, pixels, 0, milliseconds_of_processor() - start});
    const auto picture = std::make_shared<certified::Picture>();
    rungs.push_back({"", "", [=] { renderer->render(*picture); }, {}});
  }
  Pace pace;
  pace.rounds = 7;
  pace.budget = std::chrono::seconds(10);
  const std::vector<Times> times = measure(rungs, 1, pace, on_progress);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].frame_ms = median(times[i]) / 1e6;
  return points;
}

constexpr int counts[] = {1, 3, 10, 30, 100, 300, 1000, 3000, 10000};
constexpr int sides[] = {100, 200, 400, 800, 1600, 4096};

}  // namespace

std::string spheres_in_view(int count) {
  std::string scene =
      "canvas_size = 600 x 600\nlight { type = ambient  intensity = 0.2 }\n"
      "light { type = point  intensity = 0.6  position = (2, 1, 0) }\n"
      "light { type = directional  intensity = 0.2  direction = (1, 4, -4) }\n";
  for (int i = 0; i < count; ++i) {
    const double z = 5 + 40 * spread(i, 0.5497004779);
    const double x = (0.9 * spread(i, 0.7548776662) - 0.45) * z;
    const double y = (0.9 * spread(i, 0.5698402910) - 0.45) * z;
    scene += fmt::format(
        "sphere {{ center = ({:.4f}, {:.4f}, {:.4f}) radius = {:.5f} color = ({}, {}, {}) }}\n", x,
        y, z, 0.35 * z / std::sqrt(count), 50 + i * 7 % 200, 50 + i * 13 % 200, 50 + i * 29 % 200);
  }
  return scene;
}

std::string under_lights(int count) {
  std::string scene = std::string("canvas_size = 200 x 200\n") + lecture_spheres;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307 * spread(i, 0.7548776662);
    const double height = 0.2 + 3 * spread(i, 0.5698402910);
    const std::string place =
        fmt::format("({:.4f}, {:.4f}, {:.4f})", 3 * std::cos(angle), height, 3 * std::sin(angle));
    scene += fmt::format("light {{ type = {} intensity = {:.3g} {} = {} }}\n",
                         i % 2 == 0 ? "point" : "directional", 0.8 / count,
                         i % 2 == 0 ? "position" : "direction", place);
  }
  return scene;
}

std::vector<GrowthSeries> measure_growth(const std::function<void(double)>& on_progress) {
  std::vector<GrowthSeries> series{
      {"spheres", &text::growth_spheres, &text::growth_spheres_what, {}},
      {"lights", &text::growth_lights, &text::growth_lights_what, {}},
      {"canvas", &text::growth_canvas, &text::growth_canvas_what, {}}};
  std::vector<Subject> spheres;
  std::vector<Subject> lights;
  std::vector<Subject> canvases;
  for (const int count : counts) {
    spheres.push_back({count, spheres_in_view(count)});
    lights.push_back({count, under_lights(count)});
  }
  for (const int side : sides) {
    canvases.push_back(
        {static_cast<long>(side) * side,
         fmt::format("canvas_size = {0} x {0}\n", side) + lecture_spheres +
             "light { type = point  intensity = 0.6  position = (2, 1, 0) }\n"
             "light { type = directional  intensity = 0.2  direction = (1, 4, 4) }\n"});
  }
  const std::vector<Subject>* subjects[] = {&spheres, &lights, &canvases};
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i].points = measure_series(*subjects[i], [&](double done) {
      on_progress((static_cast<double>(i) + done) / static_cast<double>(series.size()));
    });
  }
  return series;
}

}  // namespace fos::numerics
