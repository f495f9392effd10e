#include "make_mistakes.hpp"

#include <cmath>

#include "diagnostic_scenes.hpp"
#include "light_code.hpp"
#include "scene_at.hpp"

namespace fos {
namespace {

/// Of a pixel's light, how near to the edge of its cell a float program may come.
constexpr double slack = 0.05;

/// The scenes at the precisions that a course may use.
struct Scenes {
  std::vector<SceneAt<double>> at_double;
  std::vector<SceneAt<float>> at_float;
};

Plane make_plane(const Scenes& scenes, const StageMistakes& stage, unsigned terms,
                 const MistakeSet& mistakes) {
  Plane plane;
  std::size_t pixel = 0;
  for (std::size_t i = 0; i < scenes.at_double.size(); ++i) {
    const auto at_double = mistaken_picture(scenes.at_double[i], terms, mistakes);
    const auto at_float = mistaken_picture(scenes.at_float[i], terms, mistakes);
    for (std::size_t k = 0; k < at_double.size(); ++k, ++pixel) {
      bool agree = at_double[k].sphere == at_float[k].sphere;
      std::uint16_t symbol = 0;
      if (!stage.has_light) {
        symbol = static_cast<std::uint16_t>(at_double[k].sphere);
      } else if (at_double[k].sphere != 0) {
        symbol = light_code(at_double[k].I);
        const double scale = light_scale(static_cast<double>(at_float[k].I));
        agree = agree && (symbol == not_a_number_code
                              ? std::isnan(scale)
                              : symbol - slack <= scale && scale <= symbol + 1 + slack);
      }
      plane.symbols.push_back(symbol);
      if (!agree) plane.not_compared.push_back(static_cast<std::uint16_t>(pixel));
    }
  }
  return plane;
}

/// One light alone: what it gives, and how far it is.
void add_term(StageMistakes& made, const Stage& stage, const TermScene& term) {
  const SceneAt<double> scene(term.scene);
  Symbols symbols(made.spheres.size());
  Symbols distances(made.spheres.size());
  std::size_t pixel = 0;
  for (std::size_t i = 0; i < term.base; ++i) pixel += pixels_of(base_scenes()[i]);
  const auto picture = mistaken_picture(scene, stage.terms, {});
  for (std::size_t k = 0; k < picture.size(); ++k, ++pixel) {
    if (picture[k].sphere == 0) continue;
    symbols[pixel] = picture[k].I > 0 ? light_code(picture[k].I) : light_is_behind;
    if (scene.point_lights.empty()) continue;
    const auto column = static_cast<int>(k) % scene.width;
    const auto row = static_cast<int>(k) / scene.width;
    const auto P = scene.camera_position + picture[k].t * scene.direction(column, row);
    distances[pixel] = light_code(length(scene.point_lights[0].position - P) / 4);
  }
  made.terms.push_back(std::move(symbols));
  made.distances.push_back(std::move(distances));
}

}  // namespace

StageMistakes make_mistakes(const Stage& stage) {
  Scenes scenes;
  for (const SceneText& scene : base_scenes()) {
    scenes.at_double.emplace_back(scene);
    scenes.at_float.emplace_back(scene);
  }
  StageMistakes made;
  made.spheres = make_plane(scenes, made, 0, {}).symbols;
  made.has_light = stage.terms != 0;
  const auto plane = [&](const MistakeSet& mistakes) {
    return make_plane(scenes, made, stage.terms, mistakes);
  };
  made.planes.push_back(plane({}));
  const Symbols right = made.planes[0].symbols;

  std::vector<const Misconception*> singles;
  for (const Misconception& each : misconceptions()) {
    if ((each.stages & stage_bit(stage.id)) == 0 || is_finish(each)) continue;
    singles.push_back(&each);
    made.planes.push_back(plane({each.mistake}));
    made.planes.back().first = each.mistake;
  }
  for (std::size_t i = 0; i < singles.size(); ++i) {
    for (std::size_t j = i + 1; j < singles.size(); ++j) {
      if (singles[i]->slot == singles[j]->slot) continue;
      Plane pair = plane({singles[i]->mistake, singles[j]->mistake});
      if (pair.symbols == right || pair.symbols == made.planes[i + 1].symbols ||
          pair.symbols == made.planes[j + 1].symbols) {
        continue;
      }
      pair.first = singles[i]->mistake;
      pair.second = singles[j]->mistake;
      made.planes.push_back(std::move(pair));
    }
  }
  for (const TermScene& term : term_scenes(stage)) add_term(made, stage, term);
  return made;
}

}  // namespace fos
