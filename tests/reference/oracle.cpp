#include "oracle.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "certified_light.hpp"
#include "exact_hit.hpp"
#include "stored_terms.hpp"

namespace fos::reference {
namespace {

constexpr std::array<mpfr_prec_t, precisions.size()> significand_bits{24, 53};

/// What certifying tries, in turn; if the last does not decide a pixel, it is on an edge.
constexpr std::array<mpfr_prec_t, 5> certifying_bits{96, 192, 384, 768, 1536};

struct Certified {
  StoredPixel pixel;
  std::vector<Enclosure> terms;  ///< of each light, negative ones too
};

std::string name_of(int column, int row) {
  return "pixel (column " + std::to_string(column) + ", row " + std::to_string(row) + ")";
}

/// Whether a channel has the same byte for both intensities.
bool same_byte(const mpq_class& channel, const mpq_class& I, const mpq_class& other_I) {
  return I == other_I || to_byte(channel * I) == to_byte(channel * other_I);
}

/// Whether each sum of terms gives the same bytes with the smallest and with the largest sums over
/// the lights.
bool same_bytes(const ExactScene& scene, const ExactHit& hit, const TermSums& sums) {
  const Triple<mpq_class>& color = scene.spheres[static_cast<std::size_t>(hit.sphere)].color;
  return std::all_of(all_terms.begin(), all_terms.end(), [&](Terms terms) {
    const mpq_class low = intensity(terms, scene.ambient, sums.point.low, sums.directional.low);
    const mpq_class high = intensity(terms, scene.ambient, sums.point.high, sums.directional.high);
    return std::all_of(color.begin(), color.end(),
                       [&](const mpq_class& channel) { return same_byte(channel, low, high); });
  });
}

/// The nearest multiple of 2^step, if all of `x` has the same one.
std::optional<std::int64_t> certain_multiple(const Enclosure& x, int step) {
  const std::int64_t low = to_multiple(x.low, step);
  return low == to_multiple(x.high, step) ? std::optional(low) : std::nullopt;
}

Certified certify(const ExactScene& scene, const Triple<mpq_class>& D, const ExactHit& hit,
                  int step, const std::string& name) {
  bool are_bytes_certain = false;
  for (const mpfr_prec_t bits : certifying_bits) {
    std::optional<std::vector<Enclosure>> terms = certified_terms(scene, D, hit, bits);
    if (!terms) continue;
    const TermSums sums = sum_terms(scene, *terms);
    are_bytes_certain = same_bytes(scene, hit, sums);
    if (!are_bytes_certain) continue;
    const std::optional<std::int64_t> point_term = certain_multiple(sums.point, step);
    const std::optional<std::int64_t> directional_term = certain_multiple(sums.directional, step);
    if (!point_term || !directional_term) continue;
    const TermSums exact_and_stored{{sums.point.low, from_multiple(*point_term, step)},
                                    {sums.directional.low, from_multiple(*directional_term, step)}};
    if (!same_bytes(scene, hit, exact_and_stored)) {
      throw StepError(name + ": the terms at step 2^" + std::to_string(step) +
                      " give another byte than the exact ones");
    }
    return {{hit.sphere + 1, *point_term, *directional_term, {}}, *std::move(terms)};
  }
  const std::string bits = std::to_string(certifying_bits.back()) + " bits";
  if (are_bytes_certain) {
    throw StepError(name + ": a term is between two multiples of 2^" + std::to_string(step) +
                    ", undecided at " + bits);
  }
  throw UndecidedError(
      name + ": a color is too near to the middle between two bytes: undecided at " + bits);
}

/// The sums over the lights of a kind.
struct ExactSums {
  mpq_class point;
  mpq_class directional;

  mpq_class& of(const ExactLight& light) { return light.is_point ? point : directional; }
};

std::optional<WidthCodes> width_codes(const ExactSums& widths, int step) {
  const std::optional<std::uint8_t> point_code = width_code(widths.point, step);
  const std::optional<std::uint8_t> directional_code = width_code(widths.directional, step);
  if (!point_code || !directional_code) return std::nullopt;
  return WidthCodes{*point_code, *directional_code};
}

/// No right formulation needs an exact result to stay exact: four roundings are always granted.
mpq_class least_width(const ExactLight& light, mpfr_prec_t bits) {
  mpq_class width = 4 * light.intensity;
  mpq_div_2exp(width.get_mpq_t(), width.get_mpq_t(), static_cast<mp_bitcnt_t>(bits));
  return width;
}

/// How far a program may be from the certified terms.
std::optional<WidthCodes> certified_widths(const ExactScene& scene,
                                           const std::vector<Enclosure>& exact,
                                           const std::vector<Interval>& enclosures,
                                           mpfr_prec_t bits, int step) {
  ExactSums widths;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const ExactLight& light = scene.lights[i];
    widths.of(light) += term_width(enclosures[i], exact[i], least_width(light, bits));
  }
  return width_codes(widths, step);
}

/// What a program may answer that sees another hit than the certified one: the enclosures' middles.
std::optional<StoredAlternative> alternative(const ExactScene& scene, const PossibleHit& hit,
                                             mpfr_prec_t bits, int step) {
  ExactSums terms;
  ExactSums widths;
  for (std::size_t i = 0; i < hit.terms.size(); ++i) {
    const ExactLight& light = scene.lights[i];
    const mpq_class middle = (hit.terms[i].exact_low() + hit.terms[i].exact_high()) / 2;
    terms.of(light) += std::max(mpq_class(0), middle);
    widths.of(light) += term_width(hit.terms[i], {middle, middle}, least_width(light, bits));
  }
  const std::optional<WidthCodes> codes = width_codes(widths, step);
  if (!codes) return std::nullopt;
  return StoredAlternative{hit.sphere + 1, to_multiple(terms.point, step),
                           to_multiple(terms.directional, step), *codes};
}

bool is_same(const PossibleHit& possible, const std::optional<ExactHit>& hit) {
  return hit && possible.sphere == hit->sphere && possible.sign == hit->root.sign;
}

/// What the programs of one precision may answer at a pixel, beside the certified terms.
struct Rounded {
  WidthCodes widths;
  std::vector<StoredAlternative> alternatives;
};

/// Nothing if the pixel cannot be judged. `exact` are the certified terms of `hit`.
std::optional<Rounded> rounded(const ExactScene& scene, const std::optional<ExactHit>& hit,
                               const std::vector<Enclosure>& exact, const Possible& possible,
                               mpfr_prec_t bits, int step) {
  if (!possible.judged) return std::nullopt;
  Rounded result;
  bool holds_truth = !hit && possible.background;
  if (hit && possible.background) result.alternatives.emplace_back();
  for (const PossibleHit& possible_hit : possible.hits) {
    if (is_same(possible_hit, hit)) {
      const std::optional<WidthCodes> widths =
          certified_widths(scene, exact, possible_hit.terms, bits, step);
      if (!widths) return std::nullopt;
      result.widths = *widths;
      holds_truth = true;
    } else {
      const std::optional<StoredAlternative> other = alternative(scene, possible_hit, bits, step);
      if (!other) return std::nullopt;
      result.alternatives.push_back(*other);
    }
  }
  if (!holds_truth) throw std::logic_error("an enclosure does not hold the truth");
  return result;
}

}  // namespace

Oracle::Oracle(const ExactScene& scene, int step)
    : scene_(scene),
      step_(step),
      rounded_{RoundedScene(scene, significand_bits[0]), RoundedScene(scene, significand_bits[1])} {
}

PixelTruth Oracle::truth(int column, int row) const {
  return truth(
      column, row, exact_hit(scene_, exact_direction(scene_, column, row)),
      {possible(Precision::float24, column, row), possible(Precision::double53, column, row)});
}

PixelTruth Oracle::truth(int column, int row, const std::optional<ExactHit>& hit,
                         const std::array<Possible, precisions.size()>& possible) const {
  Certified certified;
  if (hit) {
    certified =
        certify(scene_, exact_direction(scene_, column, row), *hit, step_, name_of(column, row));
  }
  PixelTruth truth{certified.pixel, {}};
  for (std::size_t i = 0; i < rounded_.size(); ++i) {
    std::optional<Rounded> answers =
        rounded(scene_, hit, certified.terms, possible[i], rounded_[i].bits(), step_);
    if (answers) truth.pixel.widths[i] = answers->widths;
    if (!answers || !answers->alternatives.empty()) {
      truth.ambiguous[i] = AmbiguousPixel{row * scene_.width + column, answers.has_value(), {}};
      if (answers) truth.ambiguous[i]->alternatives = std::move(answers->alternatives);
    }
  }
  return truth;
}

}  // namespace fos::reference
