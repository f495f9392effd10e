// How far a rung's picture is from the truth.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "canvas.hpp"
#include "fos/frame.hpp"
#include "interval_number.hpp"
#include "truth.hpp"

namespace fos::numerics {

/// Of |I − the true I|, over the pixels that show the right sphere and a finite I.
struct ErrorsOfI {
  long double max = 0;
  long double percentile_99 = 0;
  long double mean = 0;
};

struct Errors {
  std::optional<ErrorsOfI> I;  ///< nothing for what gives bytes only
  long wrong_bytes = 0;        ///< pixels with a byte that is not the right one
  long wrong_spheres = 0;      ///< pixels that show another sphere, or the background
  long open_bytes = 0;         ///< pixels for which an interval leaves more than one byte
  long open_spheres = 0;       ///< pixels for which intervals leave more than one sphere
  long not_finite = 0;         ///< pixels with a NaN or an infinity
};

/// The scene's colors: 0 is the background's, then the spheres' in the order of the file.
using Colors = std::vector<std::array<long double, 3>>;

/// Rounded to T, as a program of that precision has them.
template <class T>
Colors colors_of(const SceneText& scene);

/// The bytes of color × I, the product rounded to T, against the true ones.
template <class T>
Errors errors_of(const Canvas<T>& canvas, const Truth& truth, const Colors& colors);

/// Of intervals: the error is the half-width, a byte is open when the interval leaves another.
Errors errors_of(const Canvas<IntervalNumber>& canvas, const Truth& truth, const Colors& colors);

/// Of a frame of colors, which says neither sphere nor I: a pixel shows the true sphere when its
/// channels are the sphere's color times one number, and that is its I.
Errors errors_of(const Frame& frame, const Truth& truth, const Colors& colors);

/// Of bytes, three a pixel.
Errors errors_of(const std::vector<std::uint8_t>& rgb, const Truth& truth);

}  // namespace fos::numerics
