// ComputeLighting of the slides, with the mistakes that are made there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "fos/stage_list.hpp"
#include "mistakes.hpp"

namespace fos {

template <typename T, typename Scene>
class MistakenLight {
 public:
  using Vec = glm::vec<3, T>;

  /// `terms` are Term bits. Keeps references to the scene and the mistakes.
  MistakenLight(const Scene& scene, unsigned terms, const MistakeSet& mistakes)
      : scene_(scene), terms_(terms), mistakes_(mistakes) {}

  /// I at P. C, O and D are what it should not know: the sphere's centre and the ray.
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
        !is(Mistake::ambient_where_lit) && !is(Mistake::ambient_multiplied) &&
        !is(Mistake::ambient_is_floor) && !added_last();
    Sum sum;
    if (begins_with_I_A) add(sum.i, I_A);
    if (is(Mistake::ambient_twice)) add(sum.i, I_A);

    if ((kinds & point_term) != 0) {
      int number = -1;
      for (const auto& light : scene_.point_lights) {
        if (is_skipped(++number, scene_.point_lights.size())) continue;
        add_light(sum, number, light.intensity, P, N, light_vector(light, P, C, O, D), true);
      }
    }
    if (is(Mistake::stops_at_dark)) sum.stopped = sum.returned;  // it left one loop only
    if ((kinds & directional_term) != 0) {
      const std::size_t times = is(Mistake::loops_nested) ? scene_.point_lights.size() : 1;
      for (std::size_t time = 0; time < times; ++time) {
        int number = -1;
        for (const auto& light : scene_.directional_lights) {
          if (is_skipped(++number, scene_.directional_lights.size())) continue;
          Vec L = light.direction;
          if (is(Mistake::direction_negated)) L = -L;
          if (is(Mistake::direction_is_position)) L = L - P;
          add_light(sum, number, light.intensity, P, N, instead_of(L, P, O, D), false);
        }
      }
    }
    if (sum.returned) return sum.i;

    if (is(Mistake::sum_cut_off_at_0)) sum.i = std::max(sum.i, T(0));
    if (is(Mistake::lights_averaged) && sum.lights > 0) sum.i /= T(sum.lights);
    if (added_last() || (is(Mistake::ambient_where_lit) && sum.lit)) add(sum.i, I_A);
    if (is(Mistake::ambient_multiplied)) sum.i *= I_A;
    if (is(Mistake::ambient_is_floor)) sum.i = std::max(sum.i, I_A);
    if (is(Mistake::everything_averaged) && sum.lights > 0) sum.i /= T(sum.lights);
    return sum.i;
  }

 private:
  bool is(Mistake mistake) const { return mistakes_.has(mistake); }

  /// The sum, and how it goes on.
  struct Sum {
    T i = 0;
    int lights = 0;
    bool lit = false;       ///< some light shines
    bool stopped = false;   ///< no light after this one counts
    bool returned = false;  ///< not even what comes after the loops
  };

  /// The ambient light comes after the others.
  bool added_last() const {
    return is(Mistake::last_lit_light) || is(Mistake::last_light_only) ||
           is(Mistake::lights_averaged) || is(Mistake::sum_cut_off_at_0);
  }

  /// Whether a loop over `lights` lights does not come to this one; `number` counts from 0.
  bool is_skipped(int number, std::size_t lights) const {
    return (is(Mistake::first_light_skipped) && number == 0) ||
           (is(Mistake::last_light_skipped) && number + 1 == static_cast<int>(lights));
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
    const int first = is(Mistake::first_light_skipped) ? 1 : 0;
    if (is(Mistake::first_light_only) && number > first) return;
    ++sum.lights;
    const T I_A = is(Mistake::ambient_forgotten) ? T(0) : T(scene_.ambient_intensity);
    if (is(Mistake::ambient_per_light) || is(Mistake::ambient_again_per_light)) add(sum.i, I_A);
    T n_dot_l = dot(N, L);
    if (is(Mistake::absolute_cosine)) n_dot_l = std::abs(n_dot_l);
    bool lit = n_dot_l > 0 || is(Mistake::negative_kept) || is(Mistake::sum_cut_off_at_0);
    if (is(Mistake::sign_reversed)) lit = n_dot_l < 0;
    if (lit) {
      sum.lit = true;
      if (is(Mistake::ambient_per_lit_light) || is(Mistake::ambient_again_per_lit_light)) {
        add(sum.i, I_A);
      }
      combine(sum.i, term(intensity, n_dot_l, P, N, L, is_point));
      if (is(Mistake::returns_when_lit)) sum.stopped = sum.returned = true;
    } else {
      if (is(Mistake::assigned_always) || is(Mistake::last_light_only)) sum.i = 0;
      if (is(Mistake::stops_at_dark)) sum.stopped = true;
      if (is(Mistake::returns_at_dark)) sum.stopped = sum.returned = true;
      if (is(Mistake::returns_zero)) sum = {0, sum.lights, false, true, true};
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
    if (is(Mistake::length_is_3) || is(Mistake::every_length_is_3)) cosine = n_dot_l / 9;
    if (is(Mistake::falloff) && is_point) cosine /= dot(L, L);

    T share = cosine;
    if (is(Mistake::angle_for_cosine)) share = std::acos(cosine);
    if (is(Mistake::cosine_squared)) share = cosine * cosine;
    if (is(Mistake::root_of_cosine)) share = std::sqrt(cosine);
    if (is(Mistake::sine_for_cosine)) share = std::sqrt(1 - cosine * cosine);
    if (is(Mistake::cosine_of_cosine)) share = std::cos(cosine);
    if (is(Mistake::all_or_nothing)) share = 1;
    if (is(Mistake::intensity_forgotten)) return share;
    if (is(Mistake::ambient_for_intensity)) return T(scene_.ambient_intensity) * share;
    return intensity * share;
  }

  const Scene& scene_;
  unsigned terms_;
  const MistakeSet& mistakes_;
};

}  // namespace fos
