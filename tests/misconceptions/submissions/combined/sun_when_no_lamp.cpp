// named: nothing
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

// The slides' ComputeLighting: I_P = I_A + the sum over all lights of I_i <N, L_i> / (|N| |L_i|).
Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  // What both kinds of light have in common: I_i <N, L> / (|N| |L|), or nothing from behind.
  const auto diffuse = [&](Real intensity, const Vec3& L) {
    const Real n_dot_l = dot(N, L);
    return n_dot_l > 0 ? intensity * n_dot_l / (length(N) * length(L)) : 0;
  };

  Real i = scene.ambient_intensity;
  for (const PointLight& light : scene.point_lights) {
    i += diffuse(light.intensity, light.position - P);
  }
  if (scene.point_lights.empty())
    for (const DirectionalLight& light : scene.directional_lights) {
    i += diffuse(light.intensity, light.direction);
  }
  return i;
}

// The slides' TraceRay, from the line that replaces `return closest_sphere.color` on.
Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  const Vec3 P = O + hit->t * D;     // the intersection
  Vec3 N = P - hit->sphere->center;  // the sphere's normal there
  N = N / length(N);
  return hit->sphere->color * compute_lighting(P, N, scene);
}

}  // namespace fos
