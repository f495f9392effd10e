// One sphere along one row of the canvas, in floats, with what bounds their errors.
//
// docs/en/numerics.md derives the bounds; here u = 2^-24 is half an ulp of 1 in float, and a hat
// marks what is computed. Written with one rounding an operation; a fused one rounds less.
//
//   Δ = x − xc        x − xi is exact: |Δ̂ − Δ| <= u|Δ̂| + e, where xf is off by e
//   T = k Δ²          |T̂ − T| <= 6.2u |T̂| + |k| (1.1 e²/u + 2^-148): Δ² may be subnormal
//   disc = q − T      off by at most E = E0 + 7.4u |T̂|,
//                     E0 = 2.1u |q| + δq + |k| (1.1 e²/u + 2^-148)
//   s = √disc         |ŝ − s| <= uŝ + E/ŝ
//   h = h0 + hx x     |ĥ − h| <= Eh
//   g = s + |h|       at every hit g >= g_least: g >= |h|, and g >= √(a|c|), for s² = h² − ac
//   t = |c|/g or g/a  from outside (h > 0) the near and the far root; from inside the far
//                     one, h < 0 and h >= 0. No cancellation: |t̂ − t| <= t̂ (At + Bt E/ŝ)
//   P = t D           from the camera; |P̂ − P| <= eP = t̂ |D| (At + Bt E/ŝ + 4u)
//   N = P/r − V/r     |N̂ − N| <= eN = eP/r + n0
#pragma once

#include "camera_scene.hpp"

namespace fos::certified {

/// Which roots a sphere can show.
enum class Roots {
  near,    ///< the near one: from outside, and it is never less than 1
  far,     ///< the far one: from inside
  either,  ///< from outside: the near one, or the far one where that is less than 1
};

struct RowSphere {
  const CameraSphere* sphere;
  int first_column, end_column;  ///< in this row it can only be seen here
  bool in_float;                 ///< false: floats cannot tell; where it may be seen, doubles must
  Roots roots;
  bool in_front;  ///< h > 0 all along the row
  float nearest_t;
  float q, k, xi, xf;
  float E;  ///< where k > 0; else E0
  float h0, hx;
  float c;                ///< |c|
  float a0;               ///< a = a0 + (x kx)²
  float inv_D;            ///< 1/|D|, for the longest D
  float P_error, P_rate;  ///< eP/t = P_error + P_rate/ŝ where k > 0, else P_error + P_rate E/ŝ
  float n0;
};

/// u, and what E adds for T.
inline constexpr float u = 0x1p-24F;
inline constexpr float T_share = 7.4F * u;

/// The sphere along the row at height y; false where it surely is not to be seen there. With
/// `within_outline` in the columns where it may be, else in all.
bool along_row(const CameraScene& scene, const CameraSphere& sphere, double y, bool within_outline,
               RowSphere& row);

}  // namespace fos::certified
