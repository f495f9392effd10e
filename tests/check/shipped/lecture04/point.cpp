#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {

// The slides' ComputeLighting: I = I_A + the sum over the point lights.
Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  // --- your code starts here ---
  // TODO: the light at P from I_A and the point lights.
  //   inputs  P, the point; N, the normal there; scene.ambient_intensity; scene.point_lights, each
  //           with .intensity and .position
  //   output  I
  //   formula slide "Η εξίσωση της διάχυτης ανάκλασης", with L from slide "Σημειακό φως": the light
  //           vector ends at the light. And what of a term with <N, L> < 0, or of L = 0?
  return unwritten("compute_lighting");
  // --- your code ends here ---
}

// The slides' TraceRay, from the line that replaces `return closest_sphere.color` on.
Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) {
    return scene.background_color;
  }
  // --- your code starts here ---
  // TODO: the new ending of TraceRay.
  //   inputs  O, D; hit->t; hit->sphere->center, hit->sphere->color: the closest hit
  //   output  the color of the point that the ray sees
  //   formula slide "Μεταφράζοντας τα παραπάνω σε κώδικα", "με τον νέο κώδικα": the intersection P,
  //           the normal N there (slide "Το παράδειγμα της σφαίρας : Normals"), the product
  return unwritten("trace_ray");
  // --- your code ends here ---
}

}  // namespace fos
