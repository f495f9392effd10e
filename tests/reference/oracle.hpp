// The truth about a scene: every pixel certified, and what float and double may make of it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "exact_hit.hpp"
#include "exact_scene.hpp"
#include "reference_file.hpp"
#include "rounded_scene.hpp"
#include "stage_terms.hpp"

namespace fos::reference {

/// A pixel whose byte or stored term stays open at the highest precision. Nothing is guessed.
class UndecidedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A step that is too coarse: a stored term would not give the certified byte, or is itself open.
class StepError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a reference has of one pixel.
struct PixelTruth {
  StoredPixel pixel;
  std::array<std::optional<AmbiguousPixel>, precisions.size()> ambiguous;  ///< by Precision
};

class Oracle {
 public:
  /// Terms will be multiples of 2^step. `scene` must outlive this.
  Oracle(const ExactScene& scene, int step);

  /// Certifies one pixel: its sphere, its terms to the step, and for every sum of terms the bytes,
  /// which the stored terms give too. Throws UndecidedError and
  /// StepError.
  PixelTruth truth(int column, int row) const;

  /// The same for who knows already what the ray hits, and what each precision may see.
  PixelTruth truth(int column, int row, const std::optional<ExactHit>& hit,
                   const std::array<Possible, precisions.size()>& possible) const;

  /// What a precision may see at a pixel.
  Possible possible(Precision precision, int column, int row) const {
    return rounded_[static_cast<std::size_t>(precision)].possible(column, row);
  }

 private:
  const ExactScene& scene_;
  int step_;
  std::array<RoundedScene, precisions.size()> rounded_;
};

}  // namespace fos::reference
