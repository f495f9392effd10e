#include "explanation.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostic_scenes.hpp"
#include "finish.hpp"
#include "fos/nearest.hpp"
#include "light_code.hpp"

namespace fos {
namespace {

using Vec = glm::vec<3, double>;

/// How far rounding may move a channel, as a share and of 255.
constexpr double relative = 1e-5;
constexpr double absolute = 1e-4;

std::array<double, 3> channels(const DecimalTriple& color) {
  return {nearest<double>(color[0]), nearest<double>(color[1]), nearest<double>(color[2])};
}

double shown(double channel) { return std::clamp(channel, 0.0, 255.0); }

}  // namespace

std::optional<Evidence> Evidence::of(std::span<const Frame> frames) {
  const std::vector<SceneText>& scenes = base_scenes();
  if (frames.size() < scenes.size()) return std::nullopt;
  Evidence evidence;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Frame& frame = frames[i];
    const std::size_t pixels = pixels_of(scenes[i]);
    if (frame.header.width != scenes[i].canvas_width ||
        frame.header.height != scenes[i].canvas_height || frame.channels.size() != 3 * pixels ||
        frame.unwritten.size() != pixels) {
      return std::nullopt;
    }
    for (std::size_t k = 0; k < pixels; ++k) {
      if (frame.unwritten[k] != 0) return std::nullopt;
      const std::span<const long double, 3> pixel(&frame.channels[3 * k], 3);
      evidence.finite_.push_back(is_finite(pixel));
      const auto as_shown = [](long double x) {
        return std::isnan(x) ? 0 : shown(static_cast<double>(x));
      };
      evidence.pixels_.push_back({as_shown(pixel[0]), as_shown(pixel[1]), as_shown(pixel[2])});
    }
  }
  return evidence;
}

bool Evidence::finite() const {
  return std::all_of(finite_.begin(), finite_.end(), [](bool each) { return each; });
}

Explainer::Explainer(const StageMistakes& mistakes) : mistakes_(mistakes) {
  const std::vector<SceneText>& scenes = base_scenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const SceneText& scene = scenes[i];
    scene_.insert(scene_.end(), pixels_of(scene), i);
    colors_.push_back({channels(scene.background_color)});
    for (const SphereText& sphere : scene.spheres) colors_[i].push_back(channels(sphere.color));
  }
}

bool Explainer::fits(std::size_t pixel, std::size_t sphere, double low, double high,
                     const MistakeSet& finish, const std::array<double, 3>& channels) const {
  const std::array<double, 3>& own = color(pixel, sphere);
  const Vec color_of_own(own[0], own[1], own[2]);
  const auto ending = ending_of(finish);
  Vec least;
  Vec most;
  if (sphere == 0) {
    const std::array<double, 3>& first = color(pixel, 1);
    least = most =
        background(finish, color_of_own, ended(ending, Vec(first[0], first[1], first[2]), 1.0));
  } else {
    least = ended(ending, color_of_own, total(finish, low));
    most = ended(ending, color_of_own, total(finish, high));
  }
  for (int i = 0; i < 3; ++i) {
    const double channel = channels[static_cast<std::size_t>(i)];
    const double slack = absolute + relative * channel;
    if (channel < shown(least[i]) - slack || channel > shown(most[i]) + slack) return false;
  }
  return true;
}

bool Explainer::fits(std::size_t pixel, std::uint16_t symbol, const MistakeSet& finish,
                     const Evidence& evidence) const {
  const std::size_t sphere = mistakes_.has_light ? mistakes_.spheres[pixel] : symbol;
  const bool is_lit = mistakes_.has_light && sphere != 0;
  if (is_lit && symbol == not_a_number_code) return !evidence.finite(pixel);
  const LightCell cell = is_lit ? light_cell(symbol) : LightCell{1, 1};
  return evidence.finite(pixel) &&
         fits(pixel, sphere, cell.low, cell.high, finish, evidence.pixel(pixel));
}

std::size_t Explainer::misses(const Plane& plane, const MistakeSet& finish,
                              const Evidence& evidence, std::size_t enough) const {
  std::size_t misses = 0;
  auto skipped = plane.not_compared.begin();
  for (std::size_t i = 0; i < evidence.size() && misses < enough; ++i) {
    if (skipped != plane.not_compared.end() && *skipped == i) {
      ++skipped;
    } else {
      misses += fits(i, plane.symbols[i], finish, evidence) ? 0 : 1;
    }
  }
  return misses;
}

}  // namespace fos
