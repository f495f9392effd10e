// Whether a plane of the data explains the frames of a stage program.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fos/frame.hpp"
#include "fos/scene_text.hpp"
#include "mistake_data.hpp"

namespace fos {

/// The frames of the base scenes as one row of pixels, cut off at 0..255 as they are shown.
class Evidence {
 public:
  /// Nothing where a frame is missing, of another size, or unwritten somewhere.
  static std::optional<Evidence> of(std::span<const Frame> frames);

  std::size_t size() const { return pixels_.size(); }
  const std::array<double, 3>& pixel(std::size_t i) const { return pixels_[i]; }
  bool finite(std::size_t i) const { return finite_[i]; }
  bool finite() const;

 private:
  std::vector<std::array<double, 3>> pixels_;
  std::vector<bool> finite_;
};

/// The colors of the base scenes, and what the mistakes without planes make of a plane.
class Explainer {
 public:
  /// Keeps a reference to the mistakes.
  explicit Explainer(const StageMistakes& mistakes);

  /// How many of the pixels that are compared do not look as a plane has them, with these mistakes
  /// of the ending and the background as well; it stops counting at `enough`.
  std::size_t misses(const Plane& plane, const MistakeSet& finish, const Evidence& evidence,
                     std::size_t enough) const;

  /// Whether a plane, with these mistakes of the ending and the background as well, gives the
  /// evidence at every pixel that is compared.
  bool explains(const Plane& plane, const MistakeSet& finish, const Evidence& evidence) const {
    return misses(plane, finish, evidence, 1) == 0;
  }

  /// Whether a pixel looks as its symbol in a plane says.
  bool fits(std::size_t pixel, std::uint16_t symbol, const MistakeSet& finish,
            const Evidence& evidence) const;

  /// Whether a pixel that sees `sphere` of its scene with `I` in [low, high] may look like this.
  bool fits(std::size_t pixel, std::size_t sphere, double low, double high,
            const MistakeSet& finish, const std::array<double, 3>& channels) const;

  /// The color of the background (0) or a sphere of the scene that a pixel belongs to.
  const std::array<double, 3>& color(std::size_t pixel, std::size_t sphere) const {
    return colors_[scene_[pixel]][sphere];
  }
  std::size_t scene_of(std::size_t pixel) const { return scene_[pixel]; }

 private:
  const StageMistakes& mistakes_;
  std::vector<std::size_t> scene_;                          // of each pixel
  std::vector<std::vector<std::array<double, 3>>> colors_;  // of each scene
};

}  // namespace fos
