// Scenes that nobody has published, drawn from a seed, and what becomes of a frame when a scene is
// changed in a way that can be foretold.
//
// They are ordinary scenes: what the public scenes do not fix (where the camera stands, how many
// lights of a kind, which sphere stands before which) is what a picture that was written down
// beforehand gets wrong. All numbers are whole thousandths, so that a change is exact. As in the
// public scenes nothing is nearer than t = 1, nor nearer than 1 without t.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fos::grading {

using Thousandths = std::array<long, 3>;

struct DrawnSphere {
  Thousandths center;
  long radius;  ///< thousandths
  std::array<int, 3> color;
};

struct DrawnLight {
  bool is_point;
  long intensity;      ///< thousandths, an even number
  Thousandths vector;  ///< position, or direction toward the light
};

struct DrawnScene {
  int width = 96;
  int height = 64;
  Thousandths camera{};
  std::array<int, 3> background{};
  long ambient = 0;  ///< thousandths, an even number
  std::vector<DrawnSphere> spheres;
  std::vector<DrawnLight> lights;

  std::string text() const;  ///< as a scene file
};

/// The same for the same seed and number, on every machine.
DrawnScene draw_scene(std::uint64_t seed, int number);

/// How two frames hang together that a right program makes of a scene and of the changed one.
enum class Relation {
  mirrored,  ///< x becomes -x: column c of the one is column W - c of the other
  dimmed,    ///< all intensities halved: each channel is half; the background stays
  reordered  ///< lights and spheres in another order: nothing changes
};
inline constexpr std::array relations{Relation::mirrored, Relation::dimmed, Relation::reordered};

DrawnScene changed(const DrawnScene& scene, Relation relation);

}  // namespace fos::grading
