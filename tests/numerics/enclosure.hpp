// What a right kernel of a given precision may answer: the bounds that the rungs' tests hold them
// to.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "canvas.hpp"
#include "exact_scene.hpp"
#include "fos/scene_text.hpp"
#include "rounded_scene.hpp"

namespace fos::numerics {

/// The slides' formula in intervals of `bits`: whatever a program of that precision rounds, its
/// answer lies inside. So it is derived, pixel by pixel, and not measured on what is to be judged.
class Enclosure {
 public:
  Enclosure(const SceneText& text, int bits) : bits_(bits) {
    const reference::ExactScene exact = reference::to_exact(text);
    const reference::RoundedScene rounded(exact, bits);
    for (int row = 0; row < text.canvas_height; ++row) {
      for (int column = 0; column < text.canvas_width; ++column) {
        pixels_.push_back(answers(exact, rounded.possible(column, row)));
      }
    }
  }

  /// The pixels of `canvas` that a right kernel cannot have. Where I is bounded, it may leave its
  /// enclosure by `margin` times the half-width (another right formula's own roundings) and by
  /// `relative` of all light that falls there (what an approximate instruction adds).
  template <class T>
  long violations(const Canvas<T>& canvas, double margin = 0, double relative = 0) const {
    long count = 0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const bool possible =
          is_possible(pixels_[i], canvas.sphere[i], canvas.I[i], margin, relative);
      if (!possible) ++count;
    }
    return count;
  }

 private:
  struct Answer {
    int sphere;
    bool bounded;
    mpq_class low, high;
    std::size_t terms;
  };
  struct Pixel {
    bool judged;
    std::vector<Answer> answers;
  };

  static Pixel answers(const reference::ExactScene& scene, const reference::Possible& possible) {
    Pixel pixel{possible.judged, {}};
    if (possible.background) pixel.answers.push_back({0, false, 0, 0, 0});
    for (const reference::PossibleHit& hit : possible.hits) {
      Answer answer{hit.sphere + 1, true, scene.ambient, scene.ambient, hit.terms.size()};
      for (const reference::Interval& term : hit.terms) {
        if (!term.is_bounded()) {
          answer.bounded = false;
          break;
        }
        answer.low += std::max(mpq_class(0), term.exact_low());
        answer.high += std::max(mpq_class(0), term.exact_high());
      }
      pixel.answers.push_back(answer);
    }
    return pixel;
  }

  /// Exactly: a long double is the sum of two doubles.
  static mpq_class to_exact(long double value) {
    const auto high = static_cast<double>(value);
    return mpq_class(high) + mpq_class(static_cast<double>(value - high));
  }

  bool is_possible(const Pixel& pixel, int sphere, long double I, double margin,
                   double relative) const {
    if (!pixel.judged) return true;
    for (const Answer& answer : pixel.answers) {
      if (answer.sphere != sphere) continue;
      if (!answer.bounded) return true;
      if (!std::isfinite(I)) return false;
      // I_A's own rounding and the sum's, one a light, each of at most the whole.
      const double sum = static_cast<double>(answer.terms + 1) * std::ldexp(1.0, -bits_);
      const mpq_class slack = (answer.high - answer.low) / 2 * mpq_class(margin) +
                              answer.high * mpq_class(relative + sum);
      const mpq_class exact = to_exact(I);
      if (exact >= answer.low - slack && exact <= answer.high + slack) return true;
    }
    return false;
  }

  int bits_;
  std::vector<Pixel> pixels_;
};

}  // namespace fos::numerics
