// What a live figure shows, from the numbers that its page sends.
#pragma once

#include <optional>
#include <span>

#include "fos/render.hpp"

namespace fos {

struct Figure {
  int mistake = 0;     ///< for the tracer that makes mistakes: 1 is the catalogue's first, 0 none
  unsigned terms = 0;  ///< for the same: what I is the sum of, Term bits
  View view;
  Scene scene;
};

/// The numbers are, in this order: the mistake, the terms, the canvas's width and height, how many
/// spheres, point lights and directional lights, I_A, the background; then for each sphere its
/// center, radius and color, for each light its intensity and its position or direction. Nothing
/// where there are more or fewer than these counts say, or the whole ones are not 0..16384.
std::optional<Figure> figure_of(std::span<const double> numbers);

/// The one that is being shown, with which trace_ray is called.
Figure& shown_figure();

}  // namespace fos
