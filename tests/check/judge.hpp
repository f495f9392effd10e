// The rule by which a frame is right or wrong, pixel by pixel, as linear values before the byte.
//
// What a program may answer at a pixel is derived, not guessed (docs/en/reference-data.md): one of
// the accepted spheres, and for it an interval of I. A channel is right when it lies in
//   color * [I - w, I + w],  w = margin * width of the stage's terms + (lights + 2) u I,
// with both ends moved out by 2 u of themselves for the rounding of color and product. u is half an
// ulp of 1 at the program's precision. Above 255 there is only white, so both are cut off there.
#pragma once

#include <array>
#include <functional>
#include <mutex>
#include <vector>

#include "fos/frame.hpp"
#include "fos/scene_text.hpp"
#include "fos/stage_list.hpp"
#include "pixel.hpp"
#include "reference_file.hpp"

namespace fos {

struct Interval {
  double low = 0;
  double high = 0;
};

/// One right answer at a pixel.
struct Expected {
  int sphere = 0;                     ///< 0 is the background, else its number in the file, from 1
  std::array<Interval, 3> channels;   ///< accepted, 0..255
  std::array<std::uint8_t, 3> bytes;  ///< of the exact value
};

/// How many pixels of a kind there are, and the first of them.
struct Count {
  long pixels = 0;
  Pixel first;
};

struct Verdict {
  Count not_finite;  ///< NaN or infinity
  Count unwritten;   ///< unwritten() was called
  Count wrong;       ///< in no accepted answer
  Count only_float;  ///< right to float precision only, in a program of a higher one
  Count not_judged;  ///< the derivation says nothing here; accepted if finite
  /// The pixel to look at first in a frame that does not pass: non-finite ones come first.
  Pixel first_wrong() const {
    return not_finite.pixels > 0 ? not_finite.first
           : wrong.pixels > 0    ? wrong.first
                                 : unwritten.first;
  }
  bool passes() const { return not_finite.pixels + unwritten.pixels + wrong.pixels == 0; }
};

/// Judges frames of one scene at one stage.
class Judge {
 public:
  /// `terms` as in Stage. Throws where the reference's scene does not parse.
  Judge(reference::Reference reference, unsigned terms);

  const SceneText& scene() const { return scene_; }

  /// The right answers at a pixel, the exact one first; empty where it is not judged.
  std::vector<Expected> expected(Pixel pixel, reference::Precision precision) const;

  /// `frame` is whole and of the scene's canvas.
  Verdict judge(const Frame& frame) const;

  /// Calls `visit` for each pixel that does not pass, row by row.
  void each_wrong(const Frame& frame, const std::function<void(Pixel)>& visit) const;

  /// The exact picture, at double precision. Made at the first call, and kept: it takes longer than
  /// to judge one.
  const Frame& exact() const;

 private:
  enum class Judged { right, right_to_float, not_judged, wrong, unwritten, not_finite };
  Judged judge(const Frame& frame, Pixel pixel) const;
  bool accepts(const reference::Accepted& accepted, reference::Precision precision,
               std::span<const long double, 3> channels) const;
  Frame make_exact() const;
  Expected expect(const reference::Answer& answer, reference::Precision precision) const;

  reference::Reference reference_;
  SceneText scene_;
  unsigned terms_;
  double ambient_ = 0;
  std::vector<std::array<double, 3>> colors_;  // the background's, then the spheres'
  mutable std::once_flag made_exact_;
  mutable Frame exact_;
};

}  // namespace fos
