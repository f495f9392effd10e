#include "certified_light.hpp"

#include <algorithm>
#include <cstddef>

#include "interval.hpp"
#include "light_term.hpp"
#include "rational_term.hpp"

namespace fos::reference {

std::optional<std::vector<Enclosure>> certified_terms(const ExactScene& scene,
                                                      const Triple<mpq_class>& D,
                                                      const ExactHit& hit, mpfr_prec_t bits) {
  const ExactSphere& sphere = scene.spheres[static_cast<std::size_t>(hit.sphere)];
  const HitPoint<Interval> point = hit_point(
      to_intervals(bits, scene.camera), to_intervals(bits, D), to_intervals(bits, sphere.center),
      Interval(bits, mpq_class(-hit.root.b)), Interval(bits, hit.root.discriminant), hit.root.sign,
      Interval(bits, mpq_class(2 * hit.root.a)));
  const Interval r(bits, sphere.radius);

  std::vector<Enclosure> terms;
  terms.reserve(scene.lights.size());
  for (const ExactLight& light : scene.lights) {
    if (const std::optional<mpq_class> rational = rational_term(scene, D, hit, light)) {
      terms.push_back({*rational, *rational});
      continue;
    }
    const Interval term = light_term(point, r, Interval(bits, light.intensity), light.is_point,
                                     to_intervals(bits, light.vector));
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
