#include "certified_light.hpp"

#include <algorithm>
#include <cstddef>

#include "interval.hpp"
#include "rational_term.hpp"

namespace fos::reference {

std::optional<std::vector<Enclosure>> certified_terms(const ExactScene& scene,
                                                      const Triple<mpq_class>& D,
                                                      const ExactHit& hit, mpfr_prec_t bits) {
  const ExactSphere& sphere = scene.spheres[static_cast<std::size_t>(hit.sphere)];
  const Interval root = sqrt(Interval(bits, hit.root.discriminant));
  const Interval minus_b(bits, mpq_class(-hit.root.b));
  const Interval t = (hit.root.sign < 0 ? minus_b - root : minus_b + root) /
                     Interval(bits, mpq_class(2 * hit.root.a));
  const Triple<Interval> P = to_intervals(bits, scene.camera) + t * to_intervals(bits, D);
  const Triple<Interval> N = P - to_intervals(bits, sphere.center);
  const Interval N_length(bits, sphere.radius);  // P is on the sphere

  std::vector<Enclosure> terms;
  terms.reserve(scene.lights.size());
  for (const ExactLight& light : scene.lights) {
    if (const std::optional<mpq_class> rational = rational_term(scene, D, hit, light)) {
      terms.push_back({*rational, *rational});
      continue;
    }
    const Triple<Interval> vector = to_intervals(bits, light.vector);
    const Triple<Interval> L = light.is_point ? vector - P : vector;
    const Interval term = Interval(bits, light.intensity) * dot(N, L) / (N_length * length(L));
    if (!term.is_bounded()) return std::nullopt;
    terms.push_back({term.exact_low(), term.exact_high()});
  }
  return terms;
}

TermSums sum_terms(const ExactScene& scene, const std::vector<Enclosure>& terms) {
  TermSums sums;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    Enclosure& sum = scene.lights[i].is_point ? sums.point : sums.directional;
    sum.low += std::max(mpq_class(0), terms[i].low);
    sum.high += std::max(mpq_class(0), terms[i].high);
  }
  return sums;
}

}  // namespace fos::reference
