// The last line of trace_ray: what it makes of the sphere's color and the light I.
//
// It is all that the data do not hold pixel by pixel: they hold the sphere or I, and the ending
// turns them into channels.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "mistakes.hpp"

namespace fos {

/// The channels of a pixel, 0..255 and beyond.
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
