#include <utility>

#include "fos/stage.hpp"

namespace fos {

// The slides' IntersectRaySphere: the two t where the ray O + t D meets the sphere, or twice
// infinity where it misses.
std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& sphere) {
  // --- your code starts here ---
  // TODO: where the ray meets the sphere.
  //   inputs  O, D: the ray; sphere.center, sphere.radius
  //   output  the two t, or {infinity, infinity} where there is none
  //   formula lecture 3: |O + t D - C|^2 = r^2 is a quadratic equation in t, a t^2 + b t + c = 0
  return {unwritten("intersect_ray_sphere"), 0};
  // --- your code ends here ---
}

// The slides' TraceRay: the color of the nearest sphere that the ray meets for t in [t_min, t_max],
// or the background.
Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  // --- your code starts here ---
  // TODO: what the ray sees.
  //   inputs  O, D: the ray; t_min, t_max: the closed interval of t that counts;
  //           scene.spheres, each a const Sphere& with .color; scene.background_color
  //   output  a color
  //   formula slide "Μεταφράζοντας τα παραπάνω σε κώδικα": TraceRay
  return unwritten("trace_ray");
  // --- your code ends here ---
}

}  // namespace fos
