#include "locate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis.hpp"
#include "explanation.hpp"
#include "light_code.hpp"
#include "shade.hpp"
#include "strength.hpp"
#include "term_evidence.hpp"

namespace fos {
namespace {

std::string number(std::size_t count) { return fmt::format("{}", count); }

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
      return is_shade(color, evidence_.pixel(pixel));
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
    return light_of(explainer_.color(pixel, sphere(pixel)), evidence_.pixel(pixel));
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
      if (wrong++ == 0) yours = *light, right = light_cell(data_.planes[0].symbols[i]).middle();
    }
    if (wrong == 0) return std::nullopt;
    return Location{Link::ambient,
                    {say(text::locate_ambient, {number(wrong), number(all)}),
                     say(text::locate_ambient_first,
                         {fmt::format("{:.3f}", yours), fmt::format("{:.3f}", right)})}};
  }

  /// Which points the lights of a kind reach, each alone, and how strong they are there.
  std::optional<Location> light(LightKind kind) const {
    const TermEvidence terms = look_at_terms(stage_, kind, explainer_, term_frames_);
    const std::string name =
        say(kind == LightKind::point ? text::locate_point_lights : text::locate_directional_lights);
    Location found{Link::behind, {}};
    if (terms.from_behind > 0) {
      found.words.push_back(
          say(text::locate_from_behind, {name, number(terms.from_behind), number(terms.behind)}));
    }
    if (terms.dark > 0) {
      found.words.push_back(
          say(text::locate_dark, {name, number(terms.dark), number(terms.reached)}));
    }
    if (!found.words.empty()) return found;
    const Strength strength = strength_of(terms.lit);
    if (!terms.strength_is_wrong || strength.on == Dependence::none) return std::nullopt;
    return Location{Link::strength, {say(text::locate_strength, {name, describe(strength)})}};
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
