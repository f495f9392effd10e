// One sphere along one row of the canvas, in floats, with what bounds their errors.
//
// docs/en/numerics.md derives the bounds; here u = 2^-24 is half an ulp of 1 in float, and a hat
// marks what is computed. Written with one rounding an operation; a fused one rounds less.
//
//   Δ  = x − xc            x − xi is exact (halves below 2^22), so |Δ̂ − Δ| <= u|Δ̂| + e, where e
//                          bounds the error of xf
//   T  = k Δ²              |T̂ − T| <= 6.2 u |T̂| + |k| e²/u
//   disc = q − T           |disc^ − disc| <= E = E0 + 7.4 u |T̂|,  E0 = 2.1 u |q| + δq + 1.1 |k|
//   e²/u s  = √disc             |ŝ − s| <= u ŝ + E/ŝ h  = h0 + hx x         |ĥ − h| <= Eh g  = h +
//   s (outside), s + |h| (inside); g >= √(a|c|) >= g_least for every hit, as s² = h² − ac t  = c/g,
//   or g/a       |t̂ − t| <= t̂ (At + Bt E/ŝ) P  = t D, from the camera: |P| <= reach;  |P̂ − P| <= eP
//   = reach (At + Bt E/ŝ + 4u) N  = P/r − V/r         |N̂ − N| <= eN = eP/r + n0
#pragma once

#include "camera_scene.hpp"

namespace fos::certified {

struct RowSphere {
  const CameraSphere* sphere;
  int first_column, end_column;  ///< in this row it can only be seen here
  bool in_float;                 ///< false: floats cannot tell; where it may be seen, doubles must
  bool inside;
  float nearest_t;
  float q, k, xi, xf, E0;
  float h0, hx;
  float c;   ///< |c|
  float a0;  ///< a = a0 + (x kx)²
  float At, Bt;
  float inv_r;
  float Wx, Wy, Wz;  ///< V/r
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
