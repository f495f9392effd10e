// Pictures whose every byte is proven, at the speed of SIMD floats.
//
// Floats compute each pixel with a bound of their error; the pixels that the bound does not decide
// go to doubles with a running bound, and what is still open to exact arithmetic. So every byte is
// the one that the exact formulas give, and nearly all cost what they cost without a proof.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "double_pixel.hpp"
#include "float_row.hpp"
#include "fos/scene_text.hpp"
#include "plan.hpp"

namespace fos::certified {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel, rows from the top
};

/// Which arithmetic decided the pixels.
struct Effort {
  long in_float = 0;
  long in_double = 0;
  long exact = 0;
};

/// I as the floats have it and how far it may be off, for each pixel that they shade; elsewhere the
/// error is negative. Whatever is off by more is a mistake in the bounds.
struct Claims {
  std::vector<float> I;
  std::vector<float> error;
};

class Renderer {
 public:
  /// For a stage whose I sums up `terms`; by the scene's own plan if none is given. A plan changes
  /// what is computed, never a byte. Throws std::range_error for numbers beyond 10^±10000.
  Renderer(const SceneText& scene, reference::Terms terms, std::optional<Plan> plan = {});

  /// Renders the picture, by one thread. Throws reference::UndecidedError.
  Effort render(Picture& picture, Claims* claims = nullptr) const;

  const CameraScene& scene() const { return scene_; }
  const Plan& plan() const { return plan_; }

 private:
  /// What the pixels that floats leave open need.
  struct Rest {
    DoublePixel in_double;
    std::vector<const CameraSphere*> candidates;
  };

  /// What the floats leave of a row.
  void finish_row(int row, const std::vector<RowSphere>& spheres,
                  const std::vector<Undecided>& undecided, Rest& rest, std::uint8_t* rgb,
                  Effort& effort) const;
  /// The hit by exact arithmetic, then its light by the cheapest way that decides.
  Bytes exact_bytes(int column, int row, std::span<const CameraSphere* const> candidates,
                    const DoublePixel& in_double) const;

  reference::ExactScene exact_;
  reference::Terms terms_;
  CameraScene scene_;
  Plan plan_;
  FloatLights lights_;
  std::vector<std::vector<int>> bands_;   ///< of rows: the spheres that each may show
  std::vector<std::uint8_t> background_;  ///< a row of it
};

}  // namespace fos::certified
