// The lights of a scene in floats, with what their terms may be off. row_sphere.hpp has u, eP, eN.
//
// A term is I max(0, cos). It adds nothing to the error where it is surely not positive.
//   directional  off by at most I eN + rest, rest = 5u I and what replaced a point light
//   point        off by at most I (eN + 2.1 w) + rest, rest = 18u I, w = (eP + m) / |L|
// with m = 1.1u |M| for the rounding of L = M − P. Where w > 1/64, floats do not decide.
#pragma once

#include <vector>

#include "camera_scene.hpp"

namespace fos::certified {

struct FloatDirectional {
  float I;
  float x, y, z;  ///< I times the unit vector toward the light
  float rest;
};

struct FloatPoint {
  float I;
  float x, y, z;  ///< M, from the camera
  float m;
  float rest;
};

struct FloatLights {
  bool suit = true;  ///< false: a light is out of the floats' range
  float ambient = 0;
  float brightest = 0;        ///< I is not more
  bool many = false;          ///< so many that their sum is compensated
  float sum_share = 0;        ///< what rounding may do to I, relative to it
  float error_share = 1.02F;  ///< what rounding adds to a sum of that many error bounds
  std::vector<FloatDirectional> directional;
  std::vector<FloatPoint> point;
};

/// `replaced[i]` is how much light i may differ from its directional replacement, relative to its
/// intensity, and negative where it is not replaced.
FloatLights float_lights(const CameraScene& scene, const std::vector<double>& replaced);

}  // namespace fos::certified
