// The certified terms and widths of a pixel in intervals of the machine's longest numbers, where
// they decide what the oracle decides with exact numbers and 96 bits or more.
//
// The same formulas are evaluated as the oracle evaluates them, in intervals of fewer bits. So
// these hold the oracle's intervals, and what is certain of all that these hold is so of the
// oracle's.
//
// Call all of this while a RoundUp lives; where one finds something out of range, the result of the
// call means nothing.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "exact_scene.hpp"
#include "hardware_interval.hpp"
#include "hardware_scene.hpp"
#include "reference_file.hpp"

namespace fos::certified {

/// The longest numbers whose intervals hold those of 96 bits.
using Widest =
    std::conditional_t<(std::numeric_limits<long double>::digits <= 96), long double, double>;

class WideScene {
 public:
  /// Terms are multiples of 2^step.
  WideScene(const reference::ExactScene& scene, int step);

  /// The pixel as the oracle certifies it, where the ray's first hit is known, and that each
  /// precision sees no other. Nothing where that stays open.
  std::optional<reference::StoredPixel> certify(
      int column, int row, const reference::PossibleHitOf<HardwareInterval<float>>& float_hit,
      const reference::PossibleHitOf<HardwareInterval<double>>& double_hit) const;

 private:
  using Wide = HardwareInterval<Widest>;
  using Double = HardwareInterval<double>;
  template <class Number>
  using Triple = reference::Triple<Number>;

  struct Sphere {
    Triple<Wide> C;
    Triple<Wide> CO;
    Wide r;
    Wide c;                     ///< CO . CO - r^2
    std::vector<Double> color;  ///< its different channels but 0
  };
  struct Light {
    bool is_point;
    Wide I;
    Triple<Wide> vector;
    std::array<Double, reference::precisions.size()> least_width;
  };
  /// Of each kind of light.
  template <class Number>
  struct Sums {
    Number point;
    Number directional;

    Number& of(const Light& light) { return light.is_point ? point : directional; }
  };

  static Sphere wide_sphere(const reference::ExactScene& scene,
                            const reference::ExactSphere& exact);
  void light_terms(int column, int row, int number, int sign, std::vector<Wide>& terms) const;
  std::optional<std::int64_t> certain_multiple(const Wide& x) const;
  Double with_stored(const Wide& sum, std::int64_t multiple) const;
  bool are_bytes_certain(const Sphere& sphere, const Sums<Double>& sums) const;
  template <class Real>
  std::optional<reference::WidthCodes> width_codes(
      reference::Precision precision, const std::vector<HardwareInterval<Real>>& enclosures,
      const std::vector<Double>& exact) const;
  std::optional<std::uint8_t> width_code(const Double& width) const;

  Triple<Wide> O_;
  std::vector<Wide> columns_;  ///< D's first component
  std::vector<Wide> rows_;     ///< D's second
  Wide d_;                     ///< D's third
  Double ambient_;
  std::vector<Sphere> spheres_;
  std::vector<Light> lights_;
  Widest step_;   ///< 2^step
  Widest steps_;  ///< of it in 1
};

}  // namespace fos::certified
