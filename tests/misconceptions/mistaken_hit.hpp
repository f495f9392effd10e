// The closest hit as lecture 3 finds it, with the mistakes that are made there.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>

#include "mistakes.hpp"

namespace fos {

template <typename T, typename Scene>
class MistakenHit {
 public:
  using Vec = glm::vec<3, T>;

  struct Hit {
    int sphere = 0;
    T t = infinity;
  };

  /// Keeps references to both.
  MistakenHit(const Scene& scene, const MistakeSet& mistakes)
      : scene_(scene), mistakes_(mistakes) {}

  Hit closest_hit(const Vec& O, const Vec& D, T t_min, T t_max) const {
    Hit closest;
    if (is(Mistake::farthest_sphere)) closest.t = -infinity;
    int number = 0;
    for (const auto& sphere : scene_.spheres) {
      ++number;
      if (is(Mistake::first_sphere_skipped) && number == 1) continue;
      if (is(Mistake::last_sphere_skipped) && number == static_cast<int>(scene_.spheres.size())) {
        continue;
      }
      const auto [t1, t2] = intersect(O, D, sphere);
      for (const T t : {t1, t2}) {
        const bool counts = is(Mistake::t_min_excluded) ? t_min < t : t_min <= t;
        if (!counts || !(t <= t_max) || t == infinity) continue;
        bool taken = t < closest.t;
        if (is(Mistake::first_sphere)) taken = closest.sphere == 0;
        if (is(Mistake::last_sphere)) taken = true;
        if (is(Mistake::farthest_sphere)) taken = t > closest.t;
        if (is(Mistake::last_of_equals)) taken = t <= closest.t;
        if (taken) closest = {number, t};
      }
    }
    return closest;
  }

 private:
  static constexpr T infinity = std::numeric_limits<T>::infinity();

  bool is(Mistake mistake) const { return mistakes_.has(mistake); }

  /// The two roots, or twice infinity.
  template <typename Sphere>
  std::pair<T, T> intersect(const Vec& O, const Vec& D, const Sphere& sphere) const {
    Vec CO = O - sphere.center;
    if (is(Mistake::O_forgotten)) CO = -sphere.center;
    if (is(Mistake::CO_reversed)) CO = sphere.center - O;
    const T r = sphere.radius;
    T a = dot(D, D);
    if (is(Mistake::a_is_length)) a = length(D);
    if (is(Mistake::a_is_1)) a = 1;
    const T b = (is(Mistake::b_without_2) ? T(1) : T(2)) * dot(CO, D);
    T c = dot(CO, CO) - r * r;
    if (is(Mistake::r_not_squared)) c = dot(CO, CO) - r;

    T four_ac = 4 * a * c;
    if (is(Mistake::without_4)) four_ac = a * c;
    if (is(Mistake::without_a)) four_ac = 4 * c;
    const T discriminant = is(Mistake::ac_added) ? b * b + four_ac : b * b - four_ac;
    const bool misses = is(Mistake::discriminant_reversed) ? discriminant > 0 : discriminant < 0;
    if (misses) return {infinity, infinity};
    if (is(Mistake::tangent_misses) && discriminant <= 0) return {infinity, infinity};
    if (is(Mistake::no_sphere)) return {infinity, infinity};
    const T root = is(Mistake::root_forgotten) ? discriminant : std::sqrt(discriminant);
    if (is(Mistake::b_not_divided)) return {-b - root / (2 * a), -b + root / (2 * a)};
    T divisor = 2 * a;
    if (is(Mistake::divided_by_2)) divisor = 2;
    if (is(Mistake::divided_by_a)) divisor = a;
    if (is(Mistake::multiplied_by_a)) divisor = 2 / a;
    const T near_t = (-b - root) / divisor;
    const T far_t = (-b + root) / divisor;
    if (is(Mistake::near_root_only)) return {near_t, infinity};
    if (is(Mistake::far_root_only)) return {infinity, far_t};
    return {near_t, far_t};
  }

  const Scene& scene_;
  const MistakeSet& mistakes_;
};

}  // namespace fos
