// One pixel of a certified picture in doubles with running error bounds: the slides' formulas, any
// number of spheres of any kind. Nothing where the bounds do not decide.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bounded.hpp"
#include "camera_scene.hpp"

namespace fos::certified {

class DoublePixel {
 public:
  explicit DoublePixel(const CameraScene& scene) : scene_(scene) {}

  /// The bytes of the pixel at x, y (pixels from the middle). `spheres` are all that may be seen
  /// there.
  std::optional<Bytes> bytes(std::span<const CameraSphere* const> spheres, double x, double y);

  /// The same where the hit is known: the root t of `sphere`.
  std::optional<Bytes> shaded(const CameraSphere& sphere, const Bounded& t, double x,
                              double y) const;

 private:
  /// A root of a sphere's quadratic that may be the one that is seen.
  struct Candidate {
    const CameraSphere* sphere;
    Bounded t;
    bool sure;  ///< it is a root, and t >= 1
  };
  using Vector = std::array<Bounded, 3>;

  Vector direction(double x, double y) const;
  bool add_candidates(const CameraSphere& sphere, const Vector& D, const Bounded& a);
  std::optional<Bytes> shaded(const CameraSphere& sphere, const Bounded& t, const Vector& D) const;

  const CameraScene& scene_;
  std::vector<Candidate> candidates_;
};

}  // namespace fos::certified
