#include "fast_reference.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "exact_hit.hpp"
#include "hardware_scene.hpp"
#include "oracle.hpp"
#include "sphere_map.hpp"
#include "wide_scene.hpp"

namespace fos::certified {
namespace {

using reference::Precision;
using FloatPossible = HardwarePossible<float>;
using DoublePossible = HardwarePossible<double>;

/// What `make` makes in intervals of the machine, if it is in range.
template <class Make>
auto in_range(const Make& make) -> std::optional<decltype(make())> {
  const RoundUp upward;
  std::optional<decltype(make())> result(make());
  if (!RoundUp::is_in_range()) result.reset();
  return result;
}

/// The same set as the oracle has it.
template <class Real>
reference::Possible to_mpfi(const HardwarePossible<Real>& possible) {
  constexpr mpfr_prec_t bits = HardwareInterval<Real>::digits;
  reference::Possible result{possible.judged, possible.background, {}};
  for (const auto& hit : possible.hits) {
    reference::PossibleHit& same = result.hits.emplace_back();
    same.sphere = hit.sphere;
    same.sign = hit.sign;
    for (const HardwareInterval<Real>& term : hit.terms) {
      same.terms.push_back(hull(reference::Interval(bits, mpq_class(term.low())),
                                reference::Interval(bits, mpq_class(term.high()))));
    }
  }
  return result;
}

/// Whether programs of both precisions see the same, and one thing only: so the truth is it.
bool is_one(const FloatPossible& in_float, const DoublePossible& in_double) {
  if (in_float.hits.empty() && in_double.hits.empty()) return true;
  return in_float.hits.size() == 1 && in_double.hits.size() == 1 && !in_float.background &&
         !in_double.background && in_float.hits[0].sphere == in_double.hits[0].sphere &&
         in_float.hits[0].sign == in_double.hits[0].sign;
}

class FastOracle {
 public:
  FastOracle(const reference::ExactScene& scene, int step, ReferenceEffort& effort)
      : scene_(scene),
        effort_(effort),
        oracle_(scene, step),
        float_scene_(in_range([&] { return hardware_scene<float>(scene); })),
        double_scene_(in_range([&] { return hardware_scene<double>(scene); })),
        wide_scene_(in_range([&] { return WideScene(scene, step); })) {
    if (float_scene_) {
      map_.emplace(*float_scene_, scene.width, scene.height);
    } else if (double_scene_) {
      map_.emplace(*double_scene_, scene.width, scene.height);
    }
  }

  reference::PixelTruth truth(int column, int row) const {
    const std::span<const int> some = map_ ? map_->at(column, row) : std::span<const int>();
    std::optional<FloatPossible> in_float;
    std::optional<DoublePossible> in_double;
    {
      const RoundUp upward;
      in_float = possible_in(float_scene_, column, row, some);
      in_double = possible_in(double_scene_, column, row, some);
      if (in_float && in_double && is_one(*in_float, *in_double)) {
        if (std::optional<reference::StoredPixel> pixel =
                certified(column, row, *in_float, *in_double)) {
          return {*pixel, {}};
        }
      }
    }
    ++effort_.by_oracle;
    return by_oracle(column, row, in_float, in_double);
  }

 private:
  template <class Real>
  static std::optional<HardwarePossible<Real>> possible_in(
      const std::optional<HardwareScene<Real>>& scene, int column, int row,
      std::span<const int> some) {
    if (!scene) return std::nullopt;
    RoundUp::start();
    std::optional<HardwarePossible<Real>> result(possible(*scene, column, row, some));
    if (!RoundUp::is_in_range()) result.reset();
    return result;
  }

  std::optional<reference::StoredPixel> certified(int column, int row,
                                                  const FloatPossible& in_float,
                                                  const DoublePossible& in_double) const {
    if (in_double.hits.empty()) return reference::StoredPixel{};
    if (!wide_scene_) return std::nullopt;
    RoundUp::start();
    const std::optional<reference::StoredPixel> pixel =
        wide_scene_->certify(column, row, in_float.hits[0], in_double.hits[0]);
    return RoundUp::is_in_range() ? pixel : std::nullopt;
  }

  /// The ray's first hit is among those that a double may see.
  std::optional<reference::ExactHit> exact_hit(int column, int row,
                                               const reference::Possible& in_double) const {
    std::vector<int> spheres;
    for (const reference::PossibleHit& hit : in_double.hits) {
      if (spheres.empty() || spheres.back() != hit.sphere) spheres.push_back(hit.sphere);
    }
    return reference::exact_hit(scene_, reference::exact_direction(scene_, column, row), spheres);
  }

  reference::PixelTruth by_oracle(int column, int row, const std::optional<FloatPossible>& in_float,
                                  const std::optional<DoublePossible>& in_double) const {
    if (!in_float || !in_double) ++effort_.with_mpfi;
    const std::array<reference::Possible, reference::precisions.size()> possible{
        in_float ? to_mpfi(*in_float) : oracle_.possible(Precision::float24, column, row),
        in_double ? to_mpfi(*in_double) : oracle_.possible(Precision::double53, column, row)};
    return oracle_.truth(column, row, exact_hit(column, row, possible[1]), possible);
  }

  const reference::ExactScene& scene_;
  ReferenceEffort& effort_;
  reference::Oracle oracle_;
  std::optional<HardwareScene<float>> float_scene_;
  std::optional<HardwareScene<double>> double_scene_;
  std::optional<WideScene> wide_scene_;
  std::optional<SphereMap> map_;
};

}  // namespace

reference::Reference reference(const SceneText& scene, ReferenceEffort* effort) {
  ReferenceEffort ignored;
  ReferenceEffort& counted = effort != nullptr ? *effort : ignored;
  return reference::generate(scene, [&](const reference::ExactScene& exact, int step) {
    return [oracle = std::make_shared<const FastOracle>(exact, step, counted)](
               int column, int row) { return oracle->truth(column, row); };
  });
}

}  // namespace fos::certified
