// right
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

// ένα φως κάθε φορά, κατευθείαν στο χρώμα
void shine(Color& sum, const Color& color, Real intensity, const Vec3& N, const Vec3& L) {
  const Real cosine = dot(normalize(N), normalize(L));
  if (!(cosine > 0)) return;
  for (int channel = 0; channel < 3; ++channel) sum[channel] += color[channel] * intensity * cosine;
}

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) return scene.background_color;
  const Sphere& s = *hit->sphere;
  const Vec3 P = O + hit->t * D;
  Color sum = s.color * scene.ambient_intensity;
  for (const auto& l : scene.point_lights) shine(sum, s.color, l.intensity, P - s.center, l.position - P);
  for (const auto& l : scene.directional_lights) shine(sum, s.color, l.intensity, P - s.center, l.direction);
  return sum;
}

}  // namespace fos
