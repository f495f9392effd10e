#include "locate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis.hpp"
#include "explanation.hpp"
#include "light_code.hpp"
#include "strength.hpp"

namespace fos {
namespace {

using Channels = std::array<double, 3>;

std::string number(std::size_t count) { return fmt::format("{}", count); }

/// I of a pixel, if it is this color times some I; nothing where it is not, or is cut off.
std::optional<double> light_of(const Channels& color, const Channels& pixel, bool& proportional) {
  const auto brightest =
      static_cast<std::size_t>(std::max_element(color.begin(), color.end()) - color.begin());
  const double I = color[brightest] > 0 ? pixel[brightest] / color[brightest] : 0;
  const bool cut_off = std::any_of(pixel.begin(), pixel.end(), [](double c) { return c >= 255; });
  proportional = true;
  for (std::size_t i = 0; i < 3; ++i) {
    // A channel that is cut off at 255 says no more than that.
    const double expected = color[i] * I;
    const double slack = 0.01 + 1e-3 * pixel[i];
    const bool holds = cut_off ? pixel[i] <= 255 : std::abs(pixel[i] - expected) <= slack;
    proportional = proportional && holds;
  }
  if (!proportional || cut_off) return std::nullopt;
  return I;
}

bool equal(const Channels& a, const Channels& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(a[i] - b[i]) > 0.01) return false;
  }
  return true;
}

/// Looks at the links one after the other.
class Chain {
 public:
  Chain(const Stage& stage, const Evidence& evidence, std::span<const Frame> term_frames)
      : stage_(stage),
        data_(mistakes_of(stage)),
        explainer_(data_),
        evidence_(evidence),
        term_frames_(term_frames) {}

  Location first_wrong() const {
    if (auto found = background()) return *found;
    if (auto found = spheres()) return *found;
    if (!data_.has_light) return {};
    std::vector<Location> found;
    for (const LightKind kind : {LightKind::point, LightKind::directional}) {
      if (auto of_kind = light(kind)) found.push_back(std::move(*of_kind));
    }
    // A light that shines from behind would be taken for a wrong ambient light.
    if (auto of_ambient = ambient()) found.push_back(std::move(*of_ambient));
    return found.empty() ? sum() : first_of(found);
  }

 private:
  std::size_t sphere(std::size_t pixel) const { return data_.spheres[pixel]; }

  /// The sphere whose color a pixel has, times some I in a stage with light; its own if that is
  /// one.
  std::optional<std::size_t> seen(std::size_t pixel) const {
    const auto has_color_of = [&](std::size_t other) {
      const Channels& color = explainer_.color(pixel, other);
      if (other == 0 || !data_.has_light) return equal(color, evidence_.pixel(pixel));
      bool proportional = false;
      light_of(color, evidence_.pixel(pixel), proportional);
      return proportional;
    };
    if (has_color_of(sphere(pixel))) return sphere(pixel);
    for (std::size_t other = 0; other < spheres_in(pixel); ++other) {
      if (has_color_of(other)) return other;
    }
    return std::nullopt;
  }

  std::size_t spheres_in(std::size_t pixel) const {
    return base_scenes()[explainer_.scene_of(pixel)].spheres.size() + 1;
  }

  std::optional<Location> background() const {
    std::size_t wrong = 0;
    std::size_t all = 0;
    std::size_t with_sphere = 0;
    for (std::size_t i = 0; i < evidence_.size(); ++i) {
      if (sphere(i) != 0) continue;
      ++all;
      const auto other = seen(i);
      if (other == 0U) continue;
      ++wrong;
      const bool black = equal(evidence_.pixel(i), {0, 0, 0});
      if (other && !black) ++with_sphere;
    }
    if (wrong == 0) return std::nullopt;
    Location found{Link::background, {say(text::locate_background, {number(wrong), number(all)})}};
    if (with_sphere > 0) found.words.push_back(say(text::locate_extra, {number(with_sphere)}));
    return found;
  }

  std::optional<Location> spheres() const {
    std::size_t missed = 0;
    std::size_t other_sphere = 0;
    std::size_t other_color = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < evidence_.size(); ++i) {
      if (sphere(i) == 0) continue;
      ++all;
      const auto other = seen(i);
      if (other == sphere(i)) continue;
      if (!other) {
        ++other_color;
      } else {
        ++(*other == 0 ? missed : other_sphere);
      }
    }
    Location found{Link::spheres, {}};
    if (missed > 0) found.words.push_back(say(text::locate_missed, {number(missed), number(all)}));
    if (other_sphere > 0) {
      found.words.push_back(say(text::locate_other_sphere, {number(other_sphere), number(all)}));
    }
    // In a few pixels another color may happen to fit: what most of them show decides.
    if (other_color > missed + other_sphere) {
      return Location{Link::colors, {say(text::locate_colors, {number(other_color), number(all)})}};
    }
    if (found.words.empty()) return std::nullopt;
    return found;
  }

  /// I at a pixel; nothing where a channel is cut off.
  std::optional<double> I(std::size_t pixel) const {
    bool proportional = false;
    return light_of(explainer_.color(pixel, sphere(pixel)), evidence_.pixel(pixel), proportional);
  }

  /// A value within the code's cell, or next to it by rounding.
  static bool has_code(double value, LightCode code) {
    const LightCell cell = light_cell(code);
    return cell.low - 2e-4 <= value && value <= cell.high + 2e-4;
  }
  static double middle(LightCode code) {
    const LightCell cell = light_cell(code);
    return (cell.low + cell.high) / 2;
  }

  std::optional<Location> ambient() const {
    std::size_t wrong = 0;
    std::size_t all = 0;
    double yours = 0;
    double right = 0;
    for (std::size_t i = 0; i < evidence_.size(); ++i) {
      const bool dark = sphere(i) != 0 && std::none_of(data_.terms.begin(), data_.terms.end(),
                                                       [&](const Symbols& term) {
                                                         return term[i] != light_is_behind;
                                                       });
      const auto light = dark ? I(i) : std::nullopt;
      if (!light) continue;
      ++all;
      if (has_code(*light, data_.planes[0].symbols[i])) continue;
      if (wrong++ == 0) yours = *light, right = middle(data_.planes[0].symbols[i]);
    }
    if (wrong == 0) return std::nullopt;
    return Location{Link::ambient,
                    {say(text::locate_ambient, {number(wrong), number(all)}),
                     say(text::locate_ambient_first,
                         {fmt::format("{:.3f}", yours), fmt::format("{:.3f}", right)})}};
  }

  /// Which points the lights of a kind reach, each alone, and how strong they are there.
  std::optional<Location> light(LightKind kind) const {
    const std::vector<TermScene> scenes = term_scenes(stage_);
    std::size_t from_behind = 0;
    std::size_t behind = 0;
    std::size_t dark = 0;
    std::size_t reached = 0;
    bool strength_is_wrong = false;
    std::vector<Lit> lit;
    for (std::size_t k = 0; k < scenes.size() && k < term_frames_.size(); ++k) {
      if (scenes[k].kind != kind) continue;
      const Frame& frame = term_frames_[k];
      std::size_t begin = 0;
      for (std::size_t i = 0; i < scenes[k].base; ++i) begin += pixels_of(base_scenes()[i]);
      const std::size_t pixels = pixels_of(scenes[k].scene);
      if (frame.channels.size() != 3 * pixels) continue;
      for (std::size_t p = 0; p < pixels; ++p) {
        const std::size_t pixel = begin + p;
        if (sphere(pixel) == 0) continue;
        const auto yours = I_in(frame, p, pixel);
        if (!yours) continue;
        const LightCode right = data_.terms[k][pixel];
        const bool is_lit = right != light_is_behind;
        ++(is_lit ? reached : behind);
        if (!is_lit) {
          from_behind += std::abs(*yours) > 1e-6 ? 1 : 0;
        } else if (std::abs(*yours) < 1e-6) {
          dark += light_cell(right).low > 1e-3 ? 1 : 0;  // not where the term is nearly 0 anyway
        } else {
          const LightCell cell = light_cell(right);
          const LightCell distance = light_cell(data_.distances[k][pixel]);
          const bool is_far = kind == LightKind::directional;
          strength_is_wrong = strength_is_wrong || !has_code(*yours, right);
          // Of a term near 0 the cell says nothing about the ratio.
          if (cell.low < 4e-3) continue;
          lit.push_back({{*yours / cell.high, *yours / cell.low},
                         k,
                         sphere(pixel) + 1000 * scenes[k].base,
                         is_far ? Range{} : Range{4 * distance.low, 4 * distance.high},
                         middle(right) / intensity(scenes[k].scene)});
        }
      }
    }
    const std::string name =
        say(kind == LightKind::point ? text::locate_point_lights : text::locate_directional_lights);
    Location found{Link::behind, {}};
    if (from_behind > 0) {
      found.words.push_back(
          say(text::locate_from_behind, {name, number(from_behind), number(behind)}));
    }
    if (dark > 0) {
      found.words.push_back(say(text::locate_dark, {name, number(dark), number(reached)}));
    }
    if (!found.words.empty()) return found;
    const Strength strength = strength_of(lit);
    if (!strength_is_wrong || strength.on == Dependence::none) return std::nullopt;
    return Location{Link::strength, {say(text::locate_strength, {name, describe(strength)})}};
  }

  static double intensity(const SceneText& scene) {
    return std::strtod(scene.lights.at(0).intensity.text.c_str(), nullptr);
  }

  std::optional<double> I_in(const Frame& frame, std::size_t p, std::size_t pixel) const {
    Channels channels{};
    for (std::size_t i = 0; i < 3; ++i) {
      const long double channel = frame.channels[3 * p + i];
      if (!std::isfinite(channel)) return std::nullopt;
      channels[i] = static_cast<double>(channel);
    }
    bool proportional = false;
    return light_of(explainer_.color(pixel, sphere(pixel)), channels, proportional);
  }

  static Location first_of(const std::vector<Location>& locations) {
    Location all = locations.front();
    for (const Location& each : locations) all.link = std::min(all.link, each.link);
    all.words.clear();
    for (const Location& each : locations) {
      if (each.link == all.link) {
        all.words.insert(all.words.end(), each.words.begin(), each.words.end());
      }
    }
    return all;
  }

  Location sum() const {
    const bool looked_at_all =
        !data_.terms.empty() && term_frames_.size() >= data_.terms.size() &&
        std::none_of(term_frames_.begin(), term_frames_.end(),
                     [](const Frame& frame) { return frame.channels.empty(); });
    if (!looked_at_all || explainer_.explains(data_.planes[0], {}, evidence_)) return {};
    return {Link::sum, {say(text::locate_sum)}};
  }

  const Stage& stage_;
  const StageMistakes& data_;
  Explainer explainer_;
  const Evidence& evidence_;
  std::span<const Frame> term_frames_;
};

}  // namespace

Location locate(const Stage& stage, std::span<const Frame> frames,
                std::span<const Frame> term_frames) {
  const auto evidence = Evidence::of(frames);
  if (!evidence || !evidence->finite()) return {};
  return Chain(stage, *evidence, term_frames).first_wrong();
}

}  // namespace fos
