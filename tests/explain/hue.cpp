#include "hue.hpp"

#include <cmath>

#include "fos/nearest.hpp"

namespace fos {
namespace {

constexpr long double white = 255;

LinearChannels numbers(const DecimalTriple& color) {
  return {nearest<long double>(color[0]), nearest<long double>(color[1]),
          nearest<long double>(color[2])};
}

long double largest(const LinearChannels& channels) {
  return std::max({std::abs(channels[0]), std::abs(channels[1]), std::abs(channels[2])});
}

/// How far right programs of any precision may be from a multiple of the color, and far less
/// than what tells two colors apart.
long double room(const LinearChannels& channels) {
  return are_whole(channels) ? 1 : 1e-4L * largest(channels);
}

bool is_about(const LinearChannels& channels, const LinearChannels& other, long double room) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(std::min(channels[i], white) - std::min(other[i], white)) > room) return false;
  }
  return true;
}

std::optional<SeenI> I_of(const LinearChannels& channels, const LinearChannels& color) {
  std::optional<SeenI> best;
  long double largest_color = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (color[i] > largest_color && channels[i] < white) {
      largest_color = color[i];
      best = SeenI{channels[i] / color[i], false};
    }
  }
  if (best) return best;
  // All are cut off, or may be: the darkest color is cut off last.
  for (std::size_t i = 0; i < 3; ++i) {
    if (color[i] <= 0) continue;
    const SeenI seen{channels[i] / color[i], channels[i] == white};
    if (!best || seen.value > best->value) best = seen;
  }
  return best;
}

}  // namespace

bool are_whole(const LinearChannels& channels) {
  bool between = false;
  for (const long double channel : channels) {
    if (channel != std::floor(channel)) return false;
    between |= channel > 0 && channel < white;
  }
  return between;
}

Hue hue_of(const LinearChannels& channels, const SceneText& scene, bool with_light) {
  constexpr long double dark = 1e-9L;
  Hue hue;
  hue.black = largest(channels) <= dark;
  hue.background = is_about(channels, numbers(scene.background_color), 1e-4L * white);
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const LinearChannels color = numbers(scene.spheres[i].color);
    const std::optional<SeenI> I = with_light ? I_of(channels, color) : SeenI{1, false};
    if (!I) continue;
    const LinearChannels multiple{color[0] * I->value, color[1] * I->value, color[2] * I->value};
    if (is_about(channels, multiple, room(channels)))
      hue.spheres.push_back(static_cast<int>(i + 1));
  }
  return hue;
}

std::optional<SeenI> I_of(const LinearChannels& channels, const DecimalTriple& color) {
  return I_of(channels, numbers(color));
}

}  // namespace fos
