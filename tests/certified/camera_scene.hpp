// A scene as the camera of one canvas sees it: constants that hold for every pixel, each worked out
// in exact arithmetic and rounded once, to within 2^-52 of its size.
//
// Along the row at height y (pixels, y = H/2 − 1 − row) the ray at x has D = (x kx, y ky, d). With
// V = C − O the slides' quadratic has a = D·D, b = −2h for h = V·D, c = V·V − r², and a quarter of
// its discriminant is h² − ac. Seen as a polynomial in x,
//   h² − ac = q(y) − k (x − xc(y))²
//   k  = (c − Vx²) kx²                    the same for all rows
//   xc = Vx (Vy ky y + Vz d) / ((c − Vx²) kx)                     linear in y
//   q  = c (r² (ky² y² + d²) − (Vy d − Vz ky y)²) / (c − Vx²)     quadratic in y
// (complete the square; c is the power of O, the same in the plane of the row as in space). What
// cancels in h² − ac has cancelled in the exact constants: near the silhouette both terms are as
// small as the sphere looks.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact_scene.hpp"
#include "stage_terms.hpp"

namespace fos::certified {

using Triple = std::array<double, 3>;
using Bytes = std::array<std::uint8_t, 3>;

/// Whether any pixel may see a sphere, or why none can.
enum class Sight {
  may_be_seen,
  before_plane,    ///< all of it has t < 1
  outside_canvas,  ///< all of it
  repeated,        ///< equal to an earlier one, which hides it
};

struct CameraSphere {
  int index;        ///< in the scene, from 0
  Triple V;         ///< C − O
  double V_length;  ///< |V|
  double r;
  double c;                  ///< |V|² − r²
  std::array<double, 3> q;   ///< q(y) = q0 + q1 y + q2 y²
  std::array<double, 2> xc;  ///< xc(y) = xc0 + xc1 y
  double k;
  std::array<double, 2> h;  ///< h = h0 + h1 y + hx x
  double hx;
  bool inside;             ///< the camera is in the sphere, c < 0
  bool near_only;          ///< from outside, and no near root is less than 1: no far one is seen
  bool suits_float;        ///< its numbers go through floats without overflow and underflow
  bool has_row_form;       ///< k ≠ 0: q and xc are there
  double nearest_t;        ///< a lower bound of t, at least 1
  int first_row, end_row;  ///< it cannot be seen in other rows
  int first_column, end_column;  ///< nor in other columns
  Sight sight;
  float inv_r;
  std::array<float, 3> W;  ///< V/r
  Triple color;
  int shade_count;
  std::array<float, 3> shades;        ///< the different channels of the color but 0
  std::array<float, 3> unlit_shades;  ///< their bytes where only the ambient light reaches
  std::array<int, 3> shade_of;        ///< which of them a channel is, -1 for 0
  Bytes unlit;                        ///< the bytes where no light but the ambient reaches: exact
};

struct CameraLight {
  bool is_point;
  double I;
  Triple M;  ///< point: S − O
  double M_length;
  Triple direction;  ///< M, or the L of a directional light, so long that its largest
                     ///< component is 1; 0 where M is
  double direction_length;
};

/// Within 2^-52 of its size; infinity or 0 where it is out of the range of double.
double to_double(const mpq_class& x);

struct CameraScene {
  int width, height;
  double kx, ky, d;  ///< D = (x kx, y ky, d)
  double longest_D;  ///< |D| is not more
  double ambient;
  std::vector<CameraSphere> spheres;  ///< the nearest first
  std::vector<CameraLight> lights;    ///< those that the terms have and that shine
  Bytes background;

  double x(int column) const { return column - width / 2.0; }
  double y(int row) const { return height / 2.0 - 1 - row; }
};

/// `terms` is what I sums up; where it has `flat`, I is 1.
CameraScene camera_scene(const reference::ExactScene& scene, reference::Terms terms);

}  // namespace fos::certified
