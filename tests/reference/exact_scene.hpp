// A scene in exact numbers.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "fos/scene_text.hpp"
#include "triple.hpp"

namespace fos::reference {

struct ExactSphere {
  Triple<mpq_class> center;  ///< C
  mpq_class radius;          ///< r > 0
  Triple<mpq_class> color;   ///< channels 0..255
};

struct ExactLight {
  bool is_point;             ///< else directional
  mpq_class intensity;       ///< >= 0
  Triple<mpq_class> vector;  ///< point: the position; directional: L, toward the light
};

struct ExactScene {
  int width;   ///< W, pixels
  int height;  ///< H, pixels
  mpq_class viewport_width;
  mpq_class viewport_height;
  mpq_class projection_plane_d;
  Triple<mpq_class> camera;  ///< O
  Triple<mpq_class> background_color;
  std::vector<ExactSphere> spheres;
  mpq_class ambient;               ///< I_A, 0 without an ambient light
  std::vector<ExactLight> lights;  ///< point and directional ones, in the order of the file

  /// Where the ray goes through the canvas, pixels from its middle: x = c - W/2 to the right and
  /// y = H/2 - 1 - r upward. W/2 and H/2 are not rounded.
  mpq_class canvas_x(int column) const;
  mpq_class canvas_y(int row) const;
};

/// The exact value. Throws std::range_error if the exponent is beyond +-10000: such a number is of
/// no use in a scene and of any size in memory.
mpq_class to_exact(const Decimal& decimal);

ExactScene to_exact(const SceneText& scene);

}  // namespace fos::reference
