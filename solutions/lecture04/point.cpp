#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

// The slides' ComputeLighting: I = I_A + the sum over the point lights.
Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  // --- your code starts here ---
  Real i = scene.ambient_intensity;
  for (const PointLight& light : scene.point_lights) {
    const Vec3 L = light.position - P;
    const Real n_dot_l = dot(N, L);
    if (n_dot_l > 0) {
      i += light.intensity * n_dot_l / (length(N) * length(L));
    }
  }
  return i;
  // --- your code ends here ---
}

// The slides' TraceRay, from the line that replaces `return closest_sphere.color` on.
Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  // --- your code starts here ---
  const Vec3 P = O + hit->t * D;     // the intersection
  Vec3 N = P - hit->sphere->center;  // the sphere's normal there
  N = N / length(N);
  return hit->sphere->color * compute_lighting(P, N, scene);
  // --- your code ends here ---
}

}  // namespace fos
