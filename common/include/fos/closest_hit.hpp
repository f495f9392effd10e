// The closest intersection of a ray with the scene: what lecture 3 built, for the lectures after
// it.
#pragma once

#include <optional>

#include "fos/scene.hpp"

namespace fos {

struct Hit {
  Real t;                ///< the hit is at O + t D
  const Sphere* sphere;  ///< in scene.spheres
};

/// The nearest hit with t in the closed interval [t_min, t_max], or nothing. O is any point and D
/// any direction but 0, of any length. Both intersections of a sphere count, so that from inside
/// one its far side is seen; a tangent ray hits; of two equal t the sphere that comes first wins.
///
/// It solves |O + t D − C|² = r² without the slides' b² − 4ac, which loses half the digits for a
/// sphere far away (Haines, Günther, Akenine-Möller, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems, 2019).
std::optional<Hit> closest_hit(const Vec3& O, const Vec3& D, Real t_min, Real t_max,
                               const Scene& scene);

}  // namespace fos
