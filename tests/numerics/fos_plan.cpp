// fos_plan: what a scene requires to be computed, with reasons and bounds, and what each decision
// saves, measured. `./lab trade --plan` calls it.
//   fos_plan --scene F
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>

#include "certified.hpp"
#include "fit.hpp"
#include "fos/progress.hpp"
#include "fos/text.hpp"
#include "oracle.hpp"
#include "rounds.hpp"

namespace {

using namespace fos;
using namespace fos::numerics;
using certified::CameraScene;
using certified::CameraSphere;
using certified::Plan;
using certified::Renderer;
using certified::Sight;

constexpr reference::Terms all_light =
    reference::ambient | reference::point | reference::directional;

/// One decision, in words, and the plan without it where there is something to measure.
struct Decision {
  std::string words;
  std::optional<Plan> without;
};

std::string number(double x) { return fmt::format("{:.3g}", x); }

/// Why spheres are not seen; the first few by name.
void add_unseen(const CameraScene& scene, std::vector<Decision>& decisions) {
  constexpr int named = 4;
  int count = 0;
  for (const CameraSphere& sphere : scene.spheres) {
    if (sphere.sight == Sight::may_be_seen || ++count > named) continue;
    const std::string index = std::to_string(sphere.index + 1);
    const std::string words =
        sphere.sight == Sight::before_plane
            ? say(text::plan_before_plane, {index, number(sphere.V[2] + sphere.r), number(scene.d)})
        : sphere.sight == Sight::repeated ? say(text::plan_repeated, {index})
                                          : say(text::plan_outside, {index});
    decisions.push_back({words, {}});
  }
  if (count > named)
    decisions.push_back({say(text::plan_and_more, {std::to_string(count - named)}), {}});
}

/// How much of sphere times pixel lies within the outlines.
double share_within_outlines(const CameraScene& scene, const Plan& plan) {
  double within = 0;
  for (const int i : plan.spheres) {
    const CameraSphere& sphere = scene.spheres[static_cast<std::size_t>(i)];
    for (int row = sphere.first_row; row < sphere.end_row; ++row) {
      certified::RowSphere along;
      if (certified::along_row(scene, sphere, scene.y(row), true, along)) {
        within += along.end_column - along.first_column;
      }
    }
  }
  return within / (static_cast<double>(scene.width) * scene.height *
                   std::max<double>(1, static_cast<double>(plan.spheres.size())));
}

void add_lights(const CameraScene& scene, const Plan& plan, std::vector<Decision>& decisions) {
  const auto points = std::count_if(scene.lights.begin(), scene.lights.end(),
                                    [](const auto& light) { return light.is_point; });
  const auto directional = static_cast<long>(scene.lights.size()) - points;
  if (!plan.shade) {
    Plan without = plan;
    without.shade = true;
    decisions.push_back({say(text::plan_no_shade), without});
    return;
  }
  decisions.push_back(
      {say(text::plan_shade, {std::to_string(points), std::to_string(directional)}), {}});
  for (const auto& [count, kind] :
       {std::pair{points, &text::plan_point}, std::pair{directional, &text::plan_directional}}) {
    if (count == 0) decisions.push_back({say(text::plan_kind_absent, {say(*kind)}), {}});
  }
  constexpr std::size_t named = 4;
  std::size_t shown = 0;
  const double reach = certified::reach(scene);
  for (std::size_t i = 0; i < scene.lights.size() && shown < named; ++i) {
    const certified::CameraLight& light = scene.lights[i];
    if (!light.is_point) continue;
    ++shown;
    const bool replaced = plan.replaced[i] >= 0;
    decisions.push_back({say(replaced ? text::plan_replaced : text::plan_kept,
                             {std::to_string(i + 1), number(light.M_length),
                              number(certified::replacement_bound(reach, light.M_length)),
                              number(certified::replacement_budget)}),
                         {}});
  }
  const auto replaced = std::count_if(plan.replaced.begin(), plan.replaced.end(),
                                      [](double bound) { return bound >= 0; });
  if (replaced == 0) return;
  Plan without = plan;
  without.replaced.assign(plan.replaced.size(), -1);
  decisions.push_back({say(text::plan_replaced_all, {std::to_string(replaced)}), without});
}

std::vector<Decision> decisions_of(const Renderer& renderer) {
  const CameraScene& scene = renderer.scene();
  const Plan& plan = renderer.plan();
  std::vector<Decision> decisions;
  // Equal spheres would be ties at every pixel, each decided in exact arithmetic: not measured.
  Plan all_spheres = plan;
  all_spheres.spheres.clear();
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    if (scene.spheres[i].sight != Sight::repeated)
      all_spheres.spheres.push_back(static_cast<int>(i));
  }
  const bool some_unseen = all_spheres.spheres.size() != plan.spheres.size();
  Plan unseen_looked_for = all_spheres;
  unseen_looked_for.within_outlines = false;
  Plan without_outlines = plan;
  without_outlines.within_outlines = false;
  decisions.push_back({say(text::plan_spheres, {std::to_string(plan.spheres.size()),
                                                std::to_string(scene.spheres.size())}),
                       some_unseen ? std::optional(unseen_looked_for) : std::nullopt});
  add_unseen(scene, decisions);
  decisions.push_back(
      {say(text::plan_outlines, {fmt::format("{:.0f}", 100 * share_within_outlines(scene, plan))}),
       without_outlines});
  add_lights(scene, plan, decisions);

  certified::Picture picture;
  const certified::Effort effort = renderer.render(picture);
  const double pixels = static_cast<double>(scene.width) * scene.height;
  Plan in_double = plan;
  in_double.in_float = false;
  decisions.push_back(
      {say(text::plan_precision,
           {fmt::format("{:.2f}", 100 * static_cast<double>(effort.in_float) / pixels),
            fmt::format("{:.2f}", 100 * static_cast<double>(effort.in_double) / pixels),
            std::to_string(effort.exact)}),
       in_double});

  Plan none = certified::general_plan(scene);
  none.spheres = all_spheres.spheres;
  none.in_float = false;
  decisions.push_back({"", none});
  return decisions;
}

/// A canvas on which doubles from the start, for every sphere at every pixel, are a matter of
/// seconds.
int shrinkage(const SceneText& scene) {
  const double work = static_cast<double>(scene.canvas_width) * scene.canvas_height *
                      std::max<double>(1, static_cast<double>(scene.spheres.size()));
  return static_cast<int>(std::ceil(std::sqrt(std::max(1.0, work / 1e7))));
}

/// One row: the words, and at the right what is saved.
void print(const std::string& words, const std::string& saves) {
  std::cout << (saves.empty() ? words : fmt::format("{:<71} {:>6}", words, saves)) << '\n';
}

int show_plan(const std::filesystem::path& path) {
  const SceneText read = read_scene_text(path);
  for (const std::string& warning : scene_warnings(read)) std::cerr << warning << '\n';
  const int factor = shrinkage(read);
  const SceneText scene = made_smaller(read, factor);
  const auto planned = std::make_shared<Renderer>(scene, all_light);
  const std::vector<Decision> decisions = decisions_of(*planned);

  const auto rung = [](const std::shared_ptr<Renderer>& renderer) {
    auto picture = std::make_shared<certified::Picture>();
    return Rung{"", "", [=] { renderer->render(*picture); }, {}};
  };
  std::vector<Rung> rungs{rung(planned)};
  for (const Decision& decision : decisions) {
    if (decision.without)
      rungs.push_back(rung(std::make_shared<Renderer>(scene, all_light, *decision.without)));
  }
  Pace pace;
  pace.budget = std::chrono::seconds(15);
  std::vector<Times> times;
  {
    Progress progress(say(text::trade_progress_rounds), 1000);
    times = measure(rungs,
                    static_cast<std::size_t>(scene.canvas_width) *
                        static_cast<std::size_t>(scene.canvas_height),
                    pace, [&](double done) { progress.update(static_cast<long>(1000 * done)); });
  }

  print(say(text::plan_title, {path.filename().string(), std::to_string(read.canvas_width),
                               std::to_string(read.canvas_height)}),
        "");
  if (factor > 1) print(say(text::plan_smaller, {std::to_string(factor)}), "");
  print("", say(text::plan_saves));
  std::size_t next = 1;
  for (const Decision& decision : decisions) {
    std::string saves = decision.words.starts_with(' ') ? "" : "-";
    std::string words = decision.words;
    if (decision.without) {
      const Times& without = times[next++];
      saves = fmt::format("{:.0f} %", 100 * (1 - paired_ratio(times[0], without)));
      if (words.empty()) {
        words = say(text::plan_all, {number(median(times[0])), number(median(without))});
      }
    }
    print(words, saves);
  }
  print(say(text::plan_legend), "");
  return 0;
}

int failed(int status, const std::string& message) {
  std::cerr << say(text::tool_error) << ": " << message << '\n';
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 || std::strcmp(argv[1], "--scene") != 0) return failed(2, say(text::tool_usage));
  try {
    return show_plan(argv[2]);
  } catch (const SceneError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::range_error& error) {  // numbers that exact arithmetic is not made for
    return failed(2, say(text::trade_too_extreme, {error.what()}));
  } catch (const reference::UndecidedError& error) {
    return failed(2, say(text::trade_too_extreme, {error.what()}));
  } catch (const std::exception& error) {
    return failed(3, error.what());
  }
}
