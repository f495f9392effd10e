#include "finding.hpp"

#include <cmath>
#include <numeric>

#include "fos/nearest.hpp"
#include "scene_source.hpp"

namespace fos {
namespace {

bool is_finite(const LinearChannels& channels) {
  return std::isfinite(channels[0]) && std::isfinite(channels[1]) && std::isfinite(channels[2]);
}

long double middle(const reference::Enclosure& x) {
  return static_cast<long double>(mpq_class((x.low + x.high) / 2).get_d());
}

/// Closer than rounding brings any two numbers that have nothing to do with each other.
bool is_about(long double x, long double y) {
  constexpr long double room = 1e-6L;
  return std::abs(x - y) <= room * std::abs(y);
}

class Comparer {
 public:
  Comparer(const SceneText& scene, const Stage& stage, const Chain& chain,
           const RightAnswers& right, const Ask& ask_alone)
      : scene_(scene), stage_(stage), chain_(chain), right_(right), ask_alone_(ask_alone) {}

  Comparison operator()(const Ask& ask_in_picture) {
    std::vector<std::size_t> all(scene_.lights.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const Judge judge = right_.judge(all, stage_.terms);
    result_.lights.resize(scene_.lights.size());
    result_.alone = judged(ask_alone_(scene_), judge);
    if (!result_.answered()) return std::move(result_);
    result_.in_picture = judged(ask_in_picture(scene_), judge);
    note_dependence();
    if (chain_.hit && stage_.terms != 0) result_.ambient = ask_about(ambient_lights());
    find();
    if (result_.difference && result_.depends && !result_.alone.differs() &&
        result_.difference->line != Line::ambient && result_.difference->line != Line::light) {
      result_.difference->why = Why::not_alone;
    }
    return std::move(result_);
  }

 private:
  using Indices = std::vector<std::size_t>;

  Question ask_about(const Indices& lights) {
    return judged(ask_alone_(with_lights(scene_, lights)), right_.judge(lights, stage_.terms));
  }

  Indices ambient_lights() const {
    Indices lights;
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
      if (scene_.lights[i].kind == LightKind::ambient) lights.push_back(i);
    }
    return lights;
  }

  void note_dependence() {
    const Given& alone = result_.alone.given;
    const Given& in_picture = result_.in_picture->given;
    // The ray alone is the very same only in doubles.
    if (!in_picture.came() || alone.answer.header.precision != Precision::binary64) return;
    result_.depends = alone.unwritten != in_picture.unwritten;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool both_nan = std::isnan(alone.channels[i]) && std::isnan(in_picture.channels[i]);
      result_.depends |= !both_nan && alone.channels[i] != in_picture.channels[i];
    }
  }

  void differ(Line line, Why why, std::size_t light = 0) {
    result_.difference = {line, why, light};
  }

  void find() {
    const Question& whole = result_.whole();
    if (!whole.differs()) {
      result_.sphere = accepted_sphere(whole);
      if (!result_.sphere) result_.sphere = chain_.hit ? chain_.hit->sphere : 0;
    } else if (!find_sphere(whole)) {
      return;
    }
    if (!chain_.hit) {
      if (whole.differs()) differ(Line::color, why_of(whole));
      return;
    }
    if (result_.sphere && stage_.terms != 0 && !find_terms()) return;
    find_sum();
  }

  /// Whether the sphere may be the right one, or cannot be told.
  bool find_sphere(const Question& whole) {
    result_.hue.black = true;
    const bool with_light = stage_.terms != 0;
    std::vector<const Question*> questions{&whole};
    if (result_.ambient) questions.push_back(&*result_.ambient);
    for (const Question* question : questions) {
      if (!result_.hue.black) break;
      if (!question->given.came() || !is_finite(question->given.channels)) continue;
      result_.hue = hue_of(question->given.channels, scene_, with_light);
    }
    const Hue& hue = result_.hue;
    if (!chain_.hit) {
      if (hue.black || hue.spheres.empty()) return true;
      result_.sphere = hue.spheres.front();
      differ(Line::sphere, Why::sphere_seen);
      return false;
    }
    if (hue.black || hue.fits(chain_.hit->sphere)) {
      result_.sphere = chain_.hit->sphere;
      return true;
    }
    for (const Expected& expected : whole.expected) {
      if (!hue.fits(expected.sphere)) continue;
      result_.sphere = expected.sphere;
      return true;
    }
    if (hue.background) {
      result_.sphere = 0;
      differ(Line::sphere, Why::background_seen);
    } else if (!hue.spheres.empty()) {
      result_.sphere = hue.spheres.front();
      differ(Line::sphere, Why::other_sphere);
    }
    return result_.sphere == std::nullopt;
  }

  /// The color that I is seen through.
  const DecimalTriple* color() const {
    if (!result_.sphere || *result_.sphere == 0) return nullptr;
    return &scene_.spheres[static_cast<std::size_t>(*result_.sphere - 1)].color;
  }

  void see_I(Question& question) const {
    if (!question.given.came() || !is_finite(question.given.channels) || color() == nullptr) return;
    const Hue hue = hue_of(question.given.channels, scene_, true);
    if (hue.black || hue.fits(*result_.sphere))
      question.I = I_of(question.given.channels, *color());
  }

  Why why_of(const Question& question) const {
    if (question.standing == Standing::no_answer || question.standing == Standing::unwritten) {
      return Why::no_answer;
    }
    if (question.standing == Standing::not_finite) return Why::not_finite;
    if (are_cut(question)) return Why::whole_numbers;
    if (chain_.hit && stage_.terms != 0 && !question.I) return Why::no_multiple;
    return Why::different;
  }

  /// Whether it is the color as it is.
  bool is_plain(const Question& question) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (question.given.channels[i] != nearest<long double>((*color())[i])) return false;
    }
    return true;
  }

  /// Whether all terms by themselves are right.
  bool find_terms() {
    see_I(result_.alone);
    if (result_.in_picture) see_I(*result_.in_picture);
    see_I(*result_.ambient);
    if (result_.ambient->differs()) {
      const bool plain = is_plain(*result_.ambient) && is_plain(result_.whole());
      differ(Line::ambient, plain ? Why::plain_color : why_of(*result_.ambient));
      return false;
    }
    for (const LightMet& light : chain_.hit->lights) {
      std::optional<Question>& question = result_.lights[light.index];
      question = ask_about({light.index});
      see_I(*question);
      if (question->differs()) {
        differ(Line::light, why_of(*question, light), light.index);
        return false;
      }
    }
    return true;
  }

  Why why_of(const Question& question, const LightMet& light) const {
    const Why why = why_of(question);
    if (why != Why::different) return why;
    const long double I = question.I->value;
    if (!is_term(stage_, scene_.lights[light.index].kind)) return Why::no_term;
    if (light.shine == Shine::behind) return Why::behind;
    if (light.shine != Shine::lit) return Why::different;
    if (I == 0) return Why::nothing;
    const long double ratio = I / middle(light.term);
    const long double L = middle(light.L_length);
    const auto sphere = static_cast<std::size_t>(chain_.hit->sphere - 1);
    if (is_about(ratio, 1)) return Why::different;
    if (is_about(ratio, L)) return Why::times_L;
    if (is_about(ratio, 1 / L)) return Why::over_L;
    return is_about(ratio, nearest<long double>(scene_.spheres[sphere].radius)) ? Why::times_r
                                                                                : Why::different;
  }

  void find_sum() {
    const Question& whole = result_.whole();
    if (!whole.differs()) return;
    const Why why = why_of(whole);
    const bool is_color = !result_.sphere || stage_.terms == 0 || why == Why::no_multiple;
    differ(is_color ? Line::color : Line::sum, why);
  }

  const SceneText& scene_;
  const Stage& stage_;
  const Chain& chain_;
  const RightAnswers& right_;
  const Ask& ask_alone_;
  Comparison result_;
};

}  // namespace

bool is_term(const Stage& stage, LightKind kind) {
  const unsigned term = kind == LightKind::ambient ? ambient_term
                        : kind == LightKind::point ? point_term
                                                   : directional_term;
  return (stage.terms & term) != 0;
}

Comparison compare(const SceneText& scene, const Stage& stage, const Chain& chain,
                   const RightAnswers& right, const Ask& ask_alone, const Ask& ask_in_picture) {
  return Comparer(scene, stage, chain, right, ask_alone)(ask_in_picture);
}

}  // namespace fos
