// What the slides' formula may answer in floating point: the formula in intervals of the program's
// own precision.
//
// Every number is an interval whose ends have as many bits as the program's numbers, and every
// operation rounds outward to that many bits. So whatever a program's roundings, and whichever of
// its products and sums are contracted to one fused operation, its results are in the intervals.
#pragma once

#include <cstddef>
#include <vector>

#include "exact_scene.hpp"
#include "interval.hpp"
#include "possible_roots.hpp"

namespace fos::reference {

/// A hit that a program may see.
struct PossibleHit {
  int sphere;  ///< its number in the scene, from 0
  int sign;    ///< -1: at the near root, 1: at the far one
  /// For each light the enclosure of I_i <N, L_i> / (|N| |L_i|), negative ones too.
  std::vector<Interval> terms;
};

/// All that a program may see along a ray.
struct Possible {
  bool judged = true;  ///< false: some enclosure is unbounded
  bool background = false;
  std::vector<PossibleHit> hits;
};

class RoundedScene {
 public:
  /// The scene's numbers rounded to intervals of `bits`. `scene` must outlive this.
  RoundedScene(const ExactScene& scene, mpfr_prec_t bits);

  Possible possible(int column, int row) const;

  mpfr_prec_t bits() const { return bits_; }

 private:
  struct Sphere {
    int number;
    RoundedSphere rounded;
  };
  struct Candidate {
    const Sphere* sphere;
    int sign;
    bool sure;  ///< whatever the roundings, it is there and its t is not less than 1
    Interval t;
  };

  Triple<Interval> direction(int column, int row) const;
  std::vector<Candidate> candidates(const RoundedRay& ray) const;
  std::vector<Interval> terms(const Candidate& candidate, const Triple<Interval>& D) const;

  const ExactScene& scene_;
  mpfr_prec_t bits_;
  Triple<Interval> O_;
  std::vector<Sphere> spheres_;
};

}  // namespace fos::reference
