// The slides' formula in intervals of doubles: slow, but it says by itself how far it may be off.
#pragma once

#include <vector>

#include "canvas.hpp"
#include "fos/scene_text.hpp"
#include "interval_number.hpp"

namespace fos::numerics {

/// The sphere number of a pixel where the intervals leave more than one answer.
inline constexpr std::int32_t undecided = -1;

struct IntervalTriple {
  IntervalNumber x, y, z;
};

/// A scene as the smallest intervals of doubles that hold its numbers.
struct IntervalScene {
  struct Sphere {
    IntervalTriple center;
    IntervalNumber radius;
  };
  struct Light {
    bool is_point;
    IntervalNumber intensity;
    IntervalTriple vector;
  };
  int width;
  int height;
  IntervalNumber viewport_width;
  IntervalNumber viewport_height;
  IntervalNumber projection_plane_d;
  IntervalTriple O;
  std::vector<Sphere> spheres;
  IntervalNumber ambient_intensity;
  std::vector<Light> lights;
};

IntervalScene to_intervals(const SceneText& text);

void render_intervals(const IntervalScene& scene, Canvas<IntervalNumber>& out);

}  // namespace fos::numerics
