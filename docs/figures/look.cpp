// For the page that counts one cosine out: what is at a pixel.
#include <array>

#include "export.hpp"
#include "figure.hpp"
#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene);  // the stage's

}  // namespace fos

/// P, N, L to the first point light, ⟨N,L⟩, |N|, |L| and I; nothing where the ray meets nothing.
FOS_EXPORT(look) const double* look(int column, int row) {
  static std::array<double, 13> seen;
  const auto& [mistake, terms, view, scene] = fos::shown_figure();
  const fos::Vec3 O = view.camera_position;
  const fos::Vec3 D = fos::canvas_to_viewport(view, column, row);
  const auto hit = fos::closest_hit(O, D, 1, fos::infinity, scene);
  if (!hit || scene.point_lights.empty()) return nullptr;
  const fos::Vec3 P = O + hit->t * D;
  fos::Vec3 N = P - hit->sphere->center;
  N = N / length(N);
  const fos::Vec3 L = scene.point_lights[0].position - P;
  seen = {P.x,
          P.y,
          P.z,
          N.x,
          N.y,
          N.z,
          L.x,
          L.y,
          L.z,
          dot(N, L),
          length(N),
          length(L),
          fos::compute_lighting(P, N, scene)};
  return seen.data();
}
