// The contract of a stage: everything a file in labs/ needs.
//
// The letters are the lecture's: P a point on a surface, N the surface's normal there, L the vector
// from P to a light, O the ray's origin, D its direction, t how far along: the ray is O + t D.
#pragma once

#include <algorithm>
#include <cmath>

#include "fos/scene.hpp"

namespace fos {

/// The color that the ray O + t D sees, t in the closed interval [t_min, t_max]; called once for
/// each pixel, from the top left, row by row, by one thread. Every stage defines it.
///
/// O is the camera, D goes through the pixel's corner on the projection plane and is not
/// normalised, so t = 1 on that plane; the camera asks for [1, infinity].
Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene);

/// What unwritten() returns: converts to 0 and to black.
struct Unwritten {
  operator Real() const { return 0; }
  operator Color() const { return Color(0); }
};

/// Stands where your code goes. The pixel being computed shows as a checkerboard, and file and line
/// are said, once. `what` names the function that is not written yet.
Unwritten unwritten(const char* what, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE());

}  // namespace fos
