#include "rounded_scene.hpp"

#include <algorithm>
#include <utility>

namespace fos::reference {
namespace {

/// Whether the one surely comes before the other: nearer, or first in the scene of two equal ones.
bool is_before(const Interval& t, int sphere, const Interval& other_t, int other_sphere) {
  const int order = mpfr_cmp(t.high(), other_t.low());
  return order < 0 || (order == 0 && sphere < other_sphere);
}

bool is_repeated(const std::vector<ExactSphere>& spheres, std::size_t i) {
  return std::any_of(spheres.begin(), spheres.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](const ExactSphere& earlier) {
                       return earlier.center == spheres[i].center &&
                              earlier.radius == spheres[i].radius;
                     });
}

bool is_zero(const Triple<Interval>& a) {
  return std::all_of(a.begin(), a.end(),
                     [](const Interval& x) { return x.low_sign() == 0 && x.high_sign() == 0; });
}

}  // namespace

RoundedScene::RoundedScene(const ExactScene& scene, mpfr_prec_t bits)
    : scene_(scene), bits_(bits), O_(to_intervals(bits, scene.camera)) {
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    // The later of two equal spheres has the same t to the last bit, and is never seen.
    if (is_repeated(scene.spheres, i)) continue;
    const ExactSphere& sphere = scene.spheres[i];
    spheres_.push_back({static_cast<int>(i), RoundedSphere(O_, to_intervals(bits, sphere.center),
                                                           Interval(bits, sphere.radius))});
  }
}

Triple<Interval> RoundedScene::direction(int column, int row) const {
  const auto rounded = [this](const mpq_class& exact) { return Interval(bits_, exact); };
  return {rounded(scene_.canvas_x(column)) * rounded(scene_.viewport_width) / rounded(scene_.width),
          rounded(scene_.canvas_y(row)) * rounded(scene_.viewport_height) / rounded(scene_.height),
          rounded(scene_.projection_plane_d)};
}

std::vector<RoundedScene::Candidate> RoundedScene::candidates(const RoundedRay& ray) const {
  std::vector<Candidate> candidates;
  for (const Sphere& sphere : spheres_) {
    const std::optional<PossibleRoots> roots = possible_roots(sphere.rounded, ray);
    if (!roots) continue;
    for (const int sign : {-1, 1}) {
      const Interval& t = sign < 0 ? roots->near : roots->far;
      if (mpfr_cmp_ui(t.high(), 1) < 0) continue;
      const bool in_range = mpfr_cmp_ui(t.low(), 1) >= 0;
      candidates.push_back({&sphere, sign, roots->sure && in_range, t});
      // Whenever the ray hits at all, this root is in range, and the far one is not nearer.
      if (in_range) break;
    }
  }
  return candidates;
}

std::vector<Interval> RoundedScene::terms(const Candidate& candidate,
                                          const Triple<Interval>& D) const {
  const Triple<Interval> P = O_ + candidate.t * D;
  const Triple<Interval> CP = P - candidate.sphere->rounded.C;
  const Interval CP_length = length(CP);
  const Triple<Interval> N{CP[0] / CP_length, CP[1] / CP_length, CP[2] / CP_length};
  const Interval N_length = length(N);

  std::vector<Interval> terms;
  terms.reserve(scene_.lights.size());
  for (const ExactLight& light : scene_.lights) {
    const Triple<Interval> vector = to_intervals(bits_, light.vector);
    const Triple<Interval> L = light.is_point ? vector - P : vector;
    if (is_zero(L)) {
      terms.emplace_back(bits_);
    } else {
      terms.push_back(Interval(bits_, light.intensity) * dot(N, L) / (N_length * length(L)));
    }
  }
  return terms;
}

Possible RoundedScene::possible(int column, int row) const {
  const Triple<Interval> D = direction(column, row);
  const std::vector<Candidate> all = candidates(RoundedRay(D));
  Possible possible;
  possible.background =
      std::none_of(all.begin(), all.end(), [](const Candidate& c) { return c.sure; });
  for (const Candidate& candidate : all) {
    const bool hidden = std::any_of(all.begin(), all.end(), [&](const Candidate& other) {
      return other.sure &&
             is_before(other.t, other.sphere->number, candidate.t, candidate.sphere->number);
    });
    if (hidden) continue;
    PossibleHit hit{candidate.sphere->number, candidate.sign, terms(candidate, D)};
    for (const Interval& term : hit.terms) possible.judged &= term.is_bounded();
    possible.hits.push_back(std::move(hit));
  }
  return possible;
}

}  // namespace fos::reference
