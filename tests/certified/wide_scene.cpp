#include "wide_scene.hpp"

#include <algorithm>
#include <cmath>

#include "light_term.hpp"
#include "stored_terms.hpp"

namespace fos::certified {
namespace {

using reference::operator-;  // triples are arrays, so that it is not found by their namespace

constexpr std::array<int, reference::precisions.size()> significand_bits{24, 53};

/// As reference::width_code has it.
constexpr int max_width_exponent = 60;

/// Below it, Widest has every whole number and those in the middle between two.
constexpr Widest countable = 0x1p52;

/// Whether all of a channel that is not negative rounds to the same byte, and is not in the middle
/// between two.
bool is_byte_certain(const HardwareInterval<double>& channel) {
  if (channel.low() > 254.5) return true;
  const double byte = std::floor(channel.low() + 0.5);
  return channel.low() > byte - 0.5 && channel.high() < byte + 0.5;
}

/// The smallest e >= 0 with x <= 2^e.
int exponent_above(double x) {
  if (x <= 1) return 0;
  int exponent = 0;
  const double significand = std::frexp(x, &exponent);
  return significand == 0.5 ? exponent - 1 : exponent;
}

}  // namespace

WideScene::Sphere WideScene::wide_sphere(const reference::ExactScene& scene,
                                         const reference::ExactSphere& exact) {
  const Triple<mpq_class> CO = scene.camera - exact.center;
  Sphere sphere{reference::to_intervals<Wide>(Wide::digits, exact.center),
                reference::to_intervals<Wide>(Wide::digits, CO),
                Wide(Wide::digits, exact.radius),
                Wide(Wide::digits,
                     mpq_class(reference::squared_length(CO) - reference::square(exact.radius))),
                {}};
  for (auto channel = exact.color.begin(); channel != exact.color.end(); ++channel) {
    if (*channel == 0 || std::find(exact.color.begin(), channel, *channel) != channel) continue;
    sphere.color.emplace_back(Double::digits, *channel);
  }
  return sphere;
}

WideScene::WideScene(const reference::ExactScene& scene, int step)
    : O_(reference::to_intervals<Wide>(Wide::digits, scene.camera)),
      d_(Wide::digits, scene.projection_plane_d),
      ambient_(Double::digits, scene.ambient),
      step_(std::ldexp(Widest{1}, step)),
      steps_(std::ldexp(Widest{1}, -step)) {
  const auto rounded = [](const mpq_class& exact) { return Wide(Wide::digits, exact); };
  for (int column = 0; column < scene.width; ++column) {
    columns_.push_back(rounded(scene.canvas_x(column) * scene.viewport_width / scene.width));
  }
  for (int row = 0; row < scene.height; ++row) {
    rows_.push_back(rounded(scene.canvas_y(row) * scene.viewport_height / scene.height));
  }
  for (const reference::ExactSphere& sphere : scene.spheres) {
    spheres_.push_back(wide_sphere(scene, sphere));
  }
  for (const reference::ExactLight& light : scene.lights) {
    const auto least_width = [&](int bits) {
      return Double(Double::digits, reference::times_power_of_two(4 * light.intensity, -bits));
    };
    lights_.push_back({light.is_point,
                       rounded(light.intensity),
                       reference::to_intervals<Wide>(Wide::digits, light.vector),
                       {least_width(significand_bits[0]), least_width(significand_bits[1])}});
  }
}

void WideScene::light_terms(int column, int row, int number, int sign,
                            std::vector<Wide>& terms) const {
  const Triple<Wide> D{columns_[static_cast<std::size_t>(column)],
                       rows_[static_cast<std::size_t>(row)], d_};
  const Sphere& sphere = spheres_[static_cast<std::size_t>(number)];
  const Wide two(Wide::digits, 2);
  const Wide four(Wide::digits, 4);
  const Wide a = reference::squared_length(D);
  const Wide b = two * reference::dot(sphere.CO, D);
  const Wide discriminant = square(b) - four * a * sphere.c;
  const reference::HitPoint<Wide> hit =
      reference::hit_point(O_, D, sphere.C, -b, without_negative(discriminant), sign, two * a);
  for (const Light& light : lights_) {
    terms.push_back(reference::light_term(hit, sphere.r, light.I, light.is_point, light.vector));
  }
}

/// The nearest multiple of 2^step, if all of x >= 0 has the same one.
std::optional<std::int64_t> WideScene::certain_multiple(const Wide& x) const {
  const Wide steps = x * Wide::exactly(steps_) + Wide::exactly(0.5);
  if (!(steps.high() < countable)) return std::nullopt;
  const auto low = static_cast<std::int64_t>(steps.low());
  return low == static_cast<std::int64_t>(steps.high()) ? std::optional(low) : std::nullopt;
}

/// What the sum is, and what it is when its stored multiple stands for it.
WideScene::Double WideScene::with_stored(const Wide& sum, std::int64_t multiple) const {
  const Wide stored = Wide::exactly(static_cast<Widest>(multiple) * step_);
  return Double::around(hull(sum, stored));
}

/// Whether each sum of terms has the same bytes for all of `sums`.
bool WideScene::are_bytes_certain(const Sphere& sphere, const Sums<Double>& sums) const {
  const auto are_certain = [&](const Double& I) {
    return std::all_of(sphere.color.begin(), sphere.color.end(),
                       [&](const Double& channel) { return is_byte_certain(channel * I); });
  };
  // Where a kind adds 0 exactly, the other sums are all there are; without light there is one I.
  const bool point = !sums.point.is_zero();
  const bool directional = !sums.directional.is_zero();
  if (point && !(are_certain(sums.point) && are_certain(ambient_ + sums.point))) return false;
  if (directional && !(are_certain(sums.directional) && are_certain(ambient_ + sums.directional))) {
    return false;
  }
  if (!point || !directional) return true;
  const Double both = sums.point + sums.directional;
  return are_certain(both) && are_certain(ambient_ + both);
}

std::optional<std::uint8_t> WideScene::width_code(const Double& width) const {
  if (width.is_zero()) return std::uint8_t{0};
  if (width.low_sign() <= 0) return std::nullopt;
  const Double steps = width * Double::exactly(static_cast<double>(steps_)) + Double::exactly(0.5);
  const int exponent = exponent_above(steps.high());
  if (exponent != exponent_above(steps.low()) || exponent > max_width_exponent) {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(exponent + 1);
}

/// As reference::term_width has them, summed up.
template <class Real>
std::optional<reference::WidthCodes> WideScene::width_codes(
    reference::Precision precision, const std::vector<HardwareInterval<Real>>& enclosures,
    const std::vector<Double>& exact) const {
  const Double zero = Double::exactly(0);
  Sums<Double> widths{zero, zero};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Double below = exact[i] - Double::exactly(enclosures[i].low());
    const Double above = Double::exactly(enclosures[i].high()) - exact[i];
    const Double width =
        max(max(below, above), lights_[i].least_width[static_cast<std::size_t>(precision)]);
    const Double of_the_positive_part = width + exact[i] * Double::exactly(1 / reference::margin);
    Double& sum = widths.of(lights_[i]);
    sum = sum + max(zero, min(width, of_the_positive_part));
  }
  const std::optional<std::uint8_t> point = width_code(widths.point);
  const std::optional<std::uint8_t> directional = width_code(widths.directional);
  if (!point || !directional) return std::nullopt;
  return reference::WidthCodes{*point, *directional};
}

std::optional<reference::StoredPixel> WideScene::certify(
    int column, int row, const reference::PossibleHitOf<HardwareInterval<float>>& float_hit,
    const reference::PossibleHitOf<HardwareInterval<double>>& double_hit) const {
  static thread_local std::vector<Wide> terms;
  static thread_local std::vector<Double> exact;
  terms.clear();
  exact.clear();
  light_terms(column, row, double_hit.sphere, double_hit.sign, terms);
  const Wide zero = Wide::exactly(0);
  Sums<Wide> sums{zero, zero};
  for (std::size_t i = 0; i < terms.size(); ++i) {
    Wide& sum = sums.of(lights_[i]);
    sum = sum + max(zero, terms[i]);
    exact.push_back(Double::around(terms[i]));
  }
  const std::optional<std::int64_t> point = certain_multiple(sums.point);
  const std::optional<std::int64_t> directional = certain_multiple(sums.directional);
  if (!point || !directional) return std::nullopt;
  const Sphere& sphere = spheres_[static_cast<std::size_t>(double_hit.sphere)];
  if (!are_bytes_certain(
          sphere, {with_stored(sums.point, *point), with_stored(sums.directional, *directional)})) {
    return std::nullopt;
  }
  const auto float_widths = width_codes(reference::Precision::float24, float_hit.terms, exact);
  const auto double_widths = width_codes(reference::Precision::double53, double_hit.terms, exact);
  if (!float_widths || !double_widths) return std::nullopt;
  return reference::StoredPixel{
      double_hit.sphere + 1, *point, *directional, {*float_widths, *double_widths}};
}

}  // namespace fos::certified
