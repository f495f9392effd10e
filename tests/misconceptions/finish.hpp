// What comes last: the background where nothing is seen, what is done with I, and the ending of
// trace_ray, which makes a color of the sphere's and I.
//
// It is all that the data do not hold pixel by pixel: they hold the sphere or I, and these make the
// channels.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "mistakes.hpp"

namespace fos {

/// What a ray returns that meets nothing. `first_sphere` is what it would return at a hit of the
/// scene's first sphere, in full light.
template <typename T>
glm::vec<3, T> background(const MistakeSet& mistakes, const glm::vec<3, T>& color,
                          const glm::vec<3, T>& first_sphere) {
  if (mistakes.has(Mistake::black_background)) return glm::vec<3, T>(0);
  if (mistakes.has(Mistake::white_background)) return glm::vec<3, T>(255);
  if (mistakes.has(Mistake::first_sphere_is_background)) return first_sphere;
  return color;
}

/// What is made of the I that compute_lighting has summed.
template <typename T>
T total(const MistakeSet& mistakes, T I) {
  return mistakes.has(Mistake::cut_off_at_1) && I > 1 ? T(1) : I;
}

/// The channels of a pixel that sees a sphere, 0..255 and beyond.
template <typename T>
glm::vec<3, T> ended(std::optional<Mistake> ending, const glm::vec<3, T>& color, T I) {
  using Vec = glm::vec<3, T>;
  if (!ending) return color * I;
  switch (*ending) {
    case Mistake::color_plus_I:
      return color + Vec(I);
    case Mistake::light_as_grey:
      return Vec(255 * I);
    case Mistake::light_as_number:
      return Vec(I);
    case Mistake::color_without_light:
      return color;
    case Mistake::color_over_255:
      return color / T(255) * I;
    case Mistake::channels_swapped:
      return Vec(color.b, color.g, color.r) * I;
    case Mistake::truncated:
      return trunc(color * I);
    default:
      return color * I;
  }
}

}  // namespace fos
