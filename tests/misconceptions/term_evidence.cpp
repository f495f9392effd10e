#include "term_evidence.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>

#include "mistake_data.hpp"
#include "shade.hpp"

namespace fos {
namespace {

/// What is darker than this is dark.
constexpr double dark = 1e-6;

/// The frame of one light, as pixels of the base scenes.
class OneLight {
 public:
  OneLight(const Stage& stage, std::size_t number, const TermScene& scene,
           const Explainer& explainer, const Frame& frame)
      : data_(mistakes_of(stage)),
        number_(number),
        scene_(scene),
        intensity_(std::strtod(scene.scene.lights.at(0).intensity.text.c_str(), nullptr)),
        explainer_(explainer),
        frame_(frame) {
    for (std::size_t i = 0; i < scene.base; ++i) begin_ += pixels_of(base_scenes()[i]);
  }

  void add_to(TermEvidence& evidence) const {
    const std::size_t pixels = pixels_of(scene_.scene);
    if (frame_.channels.size() != 3 * pixels) return;
    for (std::size_t i = 0; i < pixels; ++i) {
      if (data_.spheres[begin_ + i] == 0) continue;
      if (const auto I = light_at(i)) add_pixel(evidence, begin_ + i, *I);
    }
  }

 private:
  std::optional<double> light_at(std::size_t i) const {
    const std::span<const long double, 3> pixel(&frame_.channels[3 * i], 3);
    if (!is_finite(pixel)) return std::nullopt;
    const Channels channels{static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
                            static_cast<double>(pixel[2])};
    return light_of(explainer_.color(begin_ + i, data_.spheres[begin_ + i]), channels);
  }

  void add_pixel(TermEvidence& evidence, std::size_t pixel, double I) const {
    const LightCode right = data_.terms[number_][pixel];
    if (right == light_is_behind) {
      ++evidence.behind;
      evidence.from_behind += std::abs(I) > dark ? 1 : 0;
      return;
    }
    ++evidence.reached;
    const LightCell cell = light_cell(right);
    if (std::abs(I) < dark) {
      evidence.dark += cell.low > 1e-3 ? 1 : 0;  // not where the term is nearly 0 anyway
      return;
    }
    evidence.strength_is_wrong = evidence.strength_is_wrong || !has_code(I, right);
    if (cell.low < 4e-3) return;  // of a term near 0 the cell says nothing about the ratio
    const LightCell distance = light_cell(data_.distances[number_][pixel]);
    Lit lit{{I / cell.high, I / cell.low},
            number_,
            data_.spheres[pixel] + 1000 * scene_.base,
            {},
            cell.middle() / intensity_};
    if (scene_.kind == LightKind::point) lit.distance = {4 * distance.low, 4 * distance.high};
    evidence.lit.push_back(lit);
  }

  const StageMistakes& data_;
  std::size_t number_;
  const TermScene& scene_;
  double intensity_;
  const Explainer& explainer_;
  const Frame& frame_;
  std::size_t begin_ = 0;
};

}  // namespace

TermEvidence look_at_terms(const Stage& stage, LightKind kind, const Explainer& explainer,
                           std::span<const Frame> term_frames) {
  TermEvidence evidence;
  const std::vector<TermScene> scenes = term_scenes(stage);
  for (std::size_t k = 0; k < scenes.size() && k < term_frames.size(); ++k) {
    if (scenes[k].kind != kind) continue;
    OneLight(stage, k, scenes[k], explainer, term_frames[k]).add_to(evidence);
  }
  return evidence;
}

}  // namespace fos
