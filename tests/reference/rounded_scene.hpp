// What the slides' formula may answer in floating point: the formula in intervals of the program's
// own precision.
//
// Every number is an interval whose ends have as many bits as the program's numbers, and every
// operation rounds outward to that many bits. So whatever a program's roundings, and whichever of
// its products and sums are contracted to one fused operation, its results are in the intervals.
//
// The oracle's Number is Interval. Another make of intervals gives the same answers if its
// operations round to the same ends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "exact_scene.hpp"
#include "interval.hpp"
#include "possible_roots.hpp"

namespace fos::reference {

/// A hit that a program may see.
template <class Number>
struct PossibleHitOf {
  int sphere;  ///< its number in the scene, from 0
  int sign;    ///< -1: at the near root, 1: at the far one
  /// For each light the enclosure of I_i <N, L_i> / (|N| |L_i|), negative ones too.
  std::vector<Number> terms;
};

/// All that a program may see along a ray.
template <class Number>
struct PossibleOf {
  bool judged = true;  ///< false: some enclosure is unbounded
  bool background = false;
  std::vector<PossibleHitOf<Number>> hits;
};

template <class Number>
class RoundedSceneOf {
 public:
  /// The scene's numbers rounded to intervals of `bits`.
  RoundedSceneOf(const ExactScene& scene, mpfr_prec_t bits);

  PossibleOf<Number> possible(int column, int row) const {
    return possible(direction(column, row), all_spheres_);
  }

  mpfr_prec_t bits() const { return bits_; }

  struct Sphere {
    int number;
    RoundedSphere<Number> rounded;
  };
  /// Without those that are equal to an earlier one.
  const std::vector<Sphere>& spheres() const { return spheres_; }

  Triple<Number> direction(int column, int row) const {
    return {columns_[static_cast<std::size_t>(column)], rows_[static_cast<std::size_t>(row)], d_};
  }

  /// Along D, where only some of spheres() can matter: their indices, rising.
  PossibleOf<Number> possible(const Triple<Number>& D, std::span<const int> some) const;

 private:
  struct Light {
    bool is_point;
    Number intensity;
    Triple<Number> vector;
  };
  struct Candidate {
    const Sphere* sphere;
    int sign;
    bool sure;  ///< whatever the roundings, it is there and its t is not less than 1
    Number t;
  };

  std::vector<Candidate> candidates(const RoundedRay<Number>& ray, std::span<const int> some) const;
  std::vector<Number> terms(const Candidate& candidate, const Triple<Number>& D) const;

  mpfr_prec_t bits_;
  Triple<Number> O_;
  std::vector<Number> columns_;  ///< D's first component
  std::vector<Number> rows_;     ///< D's second
  Number d_;                     ///< D's third
  std::vector<Sphere> spheres_;
  std::vector<int> all_spheres_;  ///< the indices of spheres_
  std::vector<Light> lights_;
};

/// Whether the one surely comes before the other: nearer, or first in the scene of two equal ones.
template <class Number>
bool is_before(const Number& t, int sphere, const Number& other_t, int other_sphere) {
  const int order = compare_ends(t, other_t);
  return order < 0 || (order == 0 && sphere < other_sphere);
}

/// Whether an earlier sphere of the scene is the same: the later has the same t to the last bit,
/// and is never seen.
bool is_repeated(const std::vector<ExactSphere>& spheres, std::size_t i);

template <class Number>
RoundedSceneOf<Number>::RoundedSceneOf(const ExactScene& scene, mpfr_prec_t bits)
    : bits_(bits),
      O_(to_intervals<Number>(bits, scene.camera)),
      d_(bits, scene.projection_plane_d) {
  const auto rounded = [bits](const mpq_class& exact) { return Number(bits, exact); };
  for (int column = 0; column < scene.width; ++column) {
    columns_.push_back(rounded(scene.canvas_x(column)) * rounded(scene.viewport_width) /
                       rounded(scene.width));
  }
  for (int row = 0; row < scene.height; ++row) {
    rows_.push_back(rounded(scene.canvas_y(row)) * rounded(scene.viewport_height) /
                    rounded(scene.height));
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    if (is_repeated(scene.spheres, i)) continue;
    const ExactSphere& sphere = scene.spheres[i];
    spheres_.push_back(
        {static_cast<int>(i), RoundedSphere<Number>(O_, to_intervals<Number>(bits, sphere.center),
                                                    rounded(sphere.radius))});
  }
  all_spheres_.resize(spheres_.size());
  std::iota(all_spheres_.begin(), all_spheres_.end(), 0);
  for (const ExactLight& light : scene.lights) {
    lights_.push_back(
        {light.is_point, rounded(light.intensity), to_intervals<Number>(bits, light.vector)});
  }
}

template <class Number>
auto RoundedSceneOf<Number>::candidates(const RoundedRay<Number>& ray,
                                        std::span<const int> some) const -> std::vector<Candidate> {
  std::vector<Candidate> candidates;
  for (const int i : some) {
    const Sphere& sphere = spheres_[static_cast<std::size_t>(i)];
    const std::optional<PossibleRoots<Number>> roots = possible_roots(sphere.rounded, ray);
    if (!roots) continue;
    for (const int sign : {-1, 1}) {
      const Number& t = sign < 0 ? roots->near : roots->far;
      if (t.is_below(1)) continue;
      const bool in_range = t.is_at_least(1);
      candidates.push_back({&sphere, sign, roots->sure && in_range, t});
      // Whenever the ray hits at all, this root is in range, and the far one is not nearer.
      if (in_range) break;
    }
  }
  return candidates;
}

template <class Number>
std::vector<Number> RoundedSceneOf<Number>::terms(const Candidate& candidate,
                                                  const Triple<Number>& D) const {
  const Triple<Number> P = O_ + candidate.t * D;
  const Triple<Number> CP = P - candidate.sphere->rounded.C;
  const Number CP_length = length(CP);
  const Triple<Number> N{CP[0] / CP_length, CP[1] / CP_length, CP[2] / CP_length};
  const Number N_length = length(N);

  std::vector<Number> terms;
  terms.reserve(lights_.size());
  for (const Light& light : lights_) {
    const Triple<Number> L = light.is_point ? light.vector - P : light.vector;
    const bool is_at_P =
        std::all_of(L.begin(), L.end(), [](const Number& x) { return x.is_zero(); });
    terms.push_back(is_at_P ? Number(bits_, 0)
                            : light.intensity * dot(N, L) / (N_length * length(L)));
  }
  return terms;
}

template <class Number>
PossibleOf<Number> RoundedSceneOf<Number>::possible(const Triple<Number>& D,
                                                    std::span<const int> some) const {
  const std::vector<Candidate> all = candidates(RoundedRay<Number>(D), some);
  PossibleOf<Number> possible;
  possible.background =
      std::none_of(all.begin(), all.end(), [](const Candidate& c) { return c.sure; });
  for (const Candidate& candidate : all) {
    const bool hidden = std::any_of(all.begin(), all.end(), [&](const Candidate& other) {
      return other.sure &&
             is_before(other.t, other.sphere->number, candidate.t, candidate.sphere->number);
    });
    if (hidden) continue;
    PossibleHitOf<Number> hit{candidate.sphere->number, candidate.sign, terms(candidate, D)};
    for (const Number& term : hit.terms) possible.judged &= term.is_bounded();
    possible.hits.push_back(std::move(hit));
  }
  return possible;
}

/// The oracle's.
using PossibleHit = PossibleHitOf<Interval>;
using Possible = PossibleOf<Interval>;
using RoundedScene = RoundedSceneOf<Interval>;
extern template class RoundedSceneOf<Interval>;

}  // namespace fos::reference
