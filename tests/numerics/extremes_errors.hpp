// An answer, pixel by pixel, against the truth.
#pragma once

#include "exact_scene.hpp"
#include "extremes.hpp"
#include "truth.hpp"

namespace fos::numerics {

/// What a program of any precision says of a pixel.
struct Said {
  int sphere = 0;  ///< as in Truth
  long double I = 1;
  bool finite = true;
};

class Measure {
 public:
  /// `scene` is where the truth is from.
  Measure(const SceneText& scene, const Truth& truth)
      : exact_(reference::to_exact(scene)), truth_(truth) {}

  Errors operator()(const std::vector<Said>& said) const;

 private:
  bool is_boundary(std::size_t pixel, int sphere) const;

  reference::ExactScene exact_;
  const Truth& truth_;
};

}  // namespace fos::numerics
