// A family of scenes, asked of the slides' formulas in this process and of the solution's program.
#include <cmath>
#include <stdexcept>

#include "extremes_errors.hpp"
#include "slides.hpp"
#include "solutions.hpp"

namespace fos::numerics {
namespace {

template <class T>
std::vector<Said> ask_slides(const SceneText& text) {
  const SceneOf<T> scene = rounded<T>(text);
  std::vector<Said> all;
  for (int row = 0; row < scene.height; ++row) {
    for (int column = 0; column < scene.width; ++column) {
      const Seen<T> seen = trace_ray(canvas_to_viewport(scene, column, row), scene);
      all.push_back({seen.sphere, seen.I, std::isfinite(T{255} * seen.I)});
    }
  }
  return all;
}

std::vector<Said> ask_slides(Precision precision, const SceneText& text) {
  switch (precision) {
    case Precision::binary32:
      return ask_slides<float>(text);
    case Precision::binary64:
      return ask_slides<double>(text);
    case Precision::extended:
      break;
  }
  return ask_slides<long double>(text);
}

std::vector<Line> lines_of(const Case& one) {
  const SceneText scene = parse_scene_text(one.scene, one.parameter);
  const SceneText right = one.truth.empty() ? scene : parse_scene_text(one.truth, one.parameter);
  const Truth truth = truth_of(right);
  const Measure measure(right, truth);
  std::vector<Line> lines;
  for (const Precision precision : all_precisions) {
    Line line{one.parameter, precision, {}};
    line.ways.push_back({measure(ask_slides(precision, scene)), {}, 0});
    const auto solution = ask_solution(precision, scene, truth);
    if (const auto* said = std::get_if<std::vector<Said>>(&solution)) {
      line.ways.push_back({measure(*said), {}, 0});
    } else {
      line.ways.push_back({{}, std::get<std::string>(solution), 0});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

Family scene_family(std::string_view id, Text title, Text finding, std::vector<Case> cases) {
  Family family{id, title, finding, {"slides", "solution"}, {}, {}};
  for (const Case& each : cases) family.parameters.push_back(each.parameter);
  family.ask = [cases = std::move(cases)](std::size_t i) { return lines_of(cases[i]); };
  return family;
}

}  // namespace fos::numerics
