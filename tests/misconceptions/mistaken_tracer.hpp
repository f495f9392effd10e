// A tracer that makes the mistakes it is told to: what each of the catalogue looks like.
//
// With no mistake it is the slides' code. Each mistake changes one line. It is written once for
// every number type and every scene that has the members of fos::Scene.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "ending.hpp"
#include "fos/stage_list.hpp"
#include "mistakes.hpp"

namespace fos {

template <typename T, typename Scene>
class MistakenTracer {
 public:
  using Vec = glm::vec<3, T>;

  /// What a pixel sees. Its color is `ended` of the two: what a stage returns.
  struct Seen {
    int sphere = 0;  ///< its number in the file, from 1; 0 is the background
    T I = 1;
    Vec color{0};
    T t = 0;
  };

  /// `terms` are Term bits, 0 for the plain color. Keeps a reference to the scene.
  MistakenTracer(const Scene& scene, unsigned terms, MistakeSet mistakes)
      : scene_(scene), terms_(terms), mistakes_(mistakes), ending_(ending_of(mistakes)) {}

  /// The ray O + t D, t in [t_min, t_max].
  Seen trace(const Vec& O, Vec D, T t_min, T t_max) const {
    if (is(Mistake::upside_down)) D.y = -D.y;
    if (is(Mistake::t_min_ignored)) t_min = 0;
    if (is(Mistake::t_min_behind)) t_min = -infinity;
    const Hit hit = closest_hit(O, D, t_min, t_max);
    if (hit.sphere == 0) {
      return {0, 1, is(Mistake::black_background) ? Vec(0) : Vec(scene_.background_color)};
    }
    const auto& sphere = scene_.spheres[static_cast<std::size_t>(hit.sphere) - 1];
    if (terms_ == 0) return {hit.sphere, 1, ended(sphere.color, 1), hit.t};

    const Vec P = point(O, D, hit.t);
    Vec N = normal(P, sphere.center, O, D);
    if (!is(Mistake::N_not_normalised)) N = N / length(N);
    const T I = is(Mistake::P_and_N_swapped) ? lighting(N, P, sphere.center, O, D)
                                             : lighting(P, N, sphere.center, O, D);
    return {hit.sphere, I, ended(sphere.color, I), hit.t};
  }

 private:
  static constexpr T infinity = std::numeric_limits<T>::infinity();

  bool is(Mistake mistake) const { return mistakes_.has(mistake); }

  // --- lecture 3 ---------------------------------------------------------------------------------

  struct Hit {
    int sphere = 0;
    T t = infinity;
  };

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
    if (is(Mistake::r_forgotten)) c = dot(CO, CO);
    if (is(Mistake::r_added)) c = dot(CO, CO) + r * r;

    T four_ac = 4 * a * c;
    if (is(Mistake::without_4)) four_ac = a * c;
    if (is(Mistake::without_a)) four_ac = 4 * c;
    const T discriminant = is(Mistake::ac_added) ? b * b + four_ac : b * b - four_ac;
    if (discriminant < 0) return {infinity, infinity};
    if (is(Mistake::tangent_misses) && discriminant <= 0) return {infinity, infinity};
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

  Hit closest_hit(const Vec& O, const Vec& D, T t_min, T t_max) const {
    Hit closest;
    if (is(Mistake::farthest_sphere)) closest.t = -infinity;
    int number = 0;
    for (const auto& sphere : scene_.spheres) {
      ++number;
      const auto [t1, t2] = intersect(O, D, sphere);
      for (const T t : {t1, t2}) {
        if (!(t_min <= t && t <= t_max) || t == infinity) continue;
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

  // --- P and N -----------------------------------------------------------------------------------

  Vec point(const Vec& O, const Vec& D, T t) const {
    if (is(Mistake::P_without_O)) return t * D;
    if (is(Mistake::P_without_t)) return O + D;
    if (is(Mistake::P_along_unit_D)) return O + t * (D / length(D));
    return O + t * D;
  }

  Vec normal(const Vec& P, const Vec& C, const Vec& O, const Vec& D) const {
    if (is(Mistake::N_inward)) return C - P;
    if (is(Mistake::N_is_P)) return P;
    if (is(Mistake::N_is_D)) return D;
    if (is(Mistake::N_to_camera)) return O - P;
    if (is(Mistake::N_turned_to_camera) && dot(P - C, D) > 0) return C - P;
    return P - C;
  }

  // --- the light ---------------------------------------------------------------------------------

  /// The sum, and how it goes on.
  struct Sum {
    T i = 0;
    int lights = 0;
    bool stopped = false;   ///< no light after this one counts
    bool returned = false;  ///< not even what comes after the loops
  };

  T lighting(const Vec& P, const Vec& N, const Vec& C, const Vec& O, const Vec& D) const {
    unsigned kinds = terms_;
    if (is(Mistake::other_lights_too)) kinds |= point_term | directional_term;
    if (is(Mistake::point_forgotten)) kinds &= ~point_term;
    if (is(Mistake::directional_forgotten)) kinds &= ~directional_term;
    if (is(Mistake::lights_forgotten)) kinds &= ambient_term;
    const T I_A = (kinds & ambient_term) != 0 && !is(Mistake::ambient_forgotten)
                      ? T(scene_.ambient_intensity)
                      : T(0);
    const bool begins_with_I_A =
        !is(Mistake::ambient_per_light) && !is(Mistake::ambient_per_lit_light) &&
        !is(Mistake::ambient_multiplied) && !is(Mistake::ambient_is_floor) && !added_last();
    Sum sum;
    if (begins_with_I_A) add(sum.i, I_A);
    if (is(Mistake::ambient_twice)) add(sum.i, I_A);

    if ((kinds & point_term) != 0) {
      int number = 0;
      for (const auto& light : scene_.point_lights) {
        add_light(sum, number++, light.intensity, P, N, light_vector(light, P, C, O, D), true);
      }
    }
    if (is(Mistake::stops_at_dark)) sum.stopped = false;  // it left one loop only
    if ((kinds & directional_term) != 0) {
      const std::size_t times = is(Mistake::loops_nested) ? scene_.point_lights.size() : 1;
      for (std::size_t time = 0; time < times; ++time) {
        int number = 0;
        for (const auto& light : scene_.directional_lights) {
          Vec L = light.direction;
          if (is(Mistake::direction_negated)) L = -L;
          if (is(Mistake::direction_is_position)) L = L - P;
          add_light(sum, number++, light.intensity, P, N, instead_of(L, P, O, D), false);
        }
      }
    }
    if (sum.returned) return sum.i;

    if (is(Mistake::lights_averaged) && sum.lights > 0) sum.i /= T(sum.lights);
    if (added_last()) add(sum.i, I_A);
    if (is(Mistake::ambient_multiplied)) sum.i *= I_A;
    if (is(Mistake::ambient_is_floor)) sum.i = std::max(sum.i, I_A);
    if (is(Mistake::cut_off_at_1)) sum.i = std::min(T(1), sum.i);
    return sum.i;
  }

  /// The ambient light comes after the others.
  bool added_last() const {
    return is(Mistake::last_lit_light) || is(Mistake::last_light_only) ||
           is(Mistake::lights_averaged);
  }

  template <typename Light>
  Vec light_vector(const Light& light, const Vec& P, const Vec& C, const Vec& O,
                   const Vec& D) const {
    if (is(Mistake::L_reversed)) return P - light.position;
    if (is(Mistake::L_is_position)) return light.position;
    if (is(Mistake::L_from_O)) return light.position - O;
    if (is(Mistake::L_from_center)) return light.position - C;
    return instead_of(light.position - P, P, O, D);
  }

  Vec instead_of(const Vec& L, const Vec& P, const Vec& O, const Vec& D) const {
    if (is(Mistake::L_is_D)) return D;
    if (is(Mistake::L_to_camera)) return O - P;
    return L;
  }

  /// `number` is the light's among those of its kind, from 0.
  void add_light(Sum& sum, int number, T intensity, const Vec& P, const Vec& N, const Vec& L,
                 bool is_point) const {
    if (sum.stopped) return;
    if (is(Mistake::first_light_only) && number > 0) return;
    ++sum.lights;
    const T I_A = is(Mistake::ambient_forgotten) ? T(0) : T(scene_.ambient_intensity);
    if (is(Mistake::ambient_per_light)) add(sum.i, I_A);
    T n_dot_l = dot(N, L);
    if (is(Mistake::absolute_cosine)) n_dot_l = std::abs(n_dot_l);
    bool lit = n_dot_l > 0 || is(Mistake::negative_kept);
    if (is(Mistake::sign_reversed)) lit = n_dot_l < 0;
    if (lit) {
      if (is(Mistake::ambient_per_lit_light)) add(sum.i, I_A);
      combine(sum.i, term(intensity, n_dot_l, P, N, L, is_point));
      if (is(Mistake::returns_when_lit)) sum.stopped = sum.returned = true;
    } else {
      if (is(Mistake::assigned_always) || is(Mistake::last_light_only)) sum.i = 0;
      if (is(Mistake::stops_at_dark)) sum.stopped = true;
      if (is(Mistake::returns_at_dark)) sum.stopped = sum.returned = true;
      if (is(Mistake::returns_zero)) sum = {0, sum.lights, true, true};
    }
    if (is(Mistake::returns_in_loop)) sum.stopped = sum.returned = true;
  }

  /// One term into the sum.
  void combine(T& i, T part) const {
    if (is(Mistake::assigned) || is(Mistake::assigned_always) || is(Mistake::last_lit_light) ||
        is(Mistake::last_light_only)) {
      i = 0;
    }
    if (is(Mistake::lights_multiplied)) {
      i *= part;
    } else if (is(Mistake::brightest_light)) {
      i = std::max(i, part);
    } else {
      add(i, part);
    }
  }

  void add(T& i, T part) const {
    i += part;
    if (is(Mistake::whole_numbers)) i = std::trunc(i);  // `int i`
  }

  T term(T intensity, T n_dot_l, const Vec& P, const Vec& N, const Vec& L, bool is_point) const {
    const T length_N = is(Mistake::N_not_normalised) ? T(1) : length(N);
    const T length_L = length(L);
    T cosine = n_dot_l / (length_N * length_L);
    if (is(Mistake::L_not_normalised)) cosine = n_dot_l / length_N;
    if (is(Mistake::divided_by_L_squared)) cosine = n_dot_l / (length_N * dot(L, L));
    if (is(Mistake::multiplied_by_L)) cosine = n_dot_l / length_N * length_L;
    if (is(Mistake::divided_by_P)) cosine = n_dot_l / (length_N * length(P));
    if (is(Mistake::falloff) && is_point) cosine /= dot(L, L);

    T share = cosine;
    if (is(Mistake::angle_for_cosine)) share = std::acos(cosine);
    if (is(Mistake::cosine_squared)) share = cosine * cosine;
    if (is(Mistake::cosine_of_cosine)) share = std::cos(cosine);
    if (is(Mistake::all_or_nothing)) share = 1;
    if (is(Mistake::intensity_forgotten)) return share;
    if (is(Mistake::ambient_for_intensity)) return T(scene_.ambient_intensity) * share;
    return intensity * share;
  }

  // --- the ending --------------------------------------------------------------------------------

  Vec ended(const Vec& color, T I) const { return fos::ended<T>(ending_, color, I); }

  const Scene& scene_;
  unsigned terms_;
  MistakeSet mistakes_;
  std::optional<Mistake> ending_;
};

}  // namespace fos
