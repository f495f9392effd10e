#include "conclusion.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstring>

#include "fos/text.hpp"
#include "number_text.hpp"

namespace fos {
namespace {

std::string seconds(const Limits& limits) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(limits.wall).count());
}

/// Why there is nothing to compare.
std::string no_answer(const Given& given) {
  switch (given.answer.ending) {
    case Ending::complete:
      return say(text::explain_unwritten);
    case Ending::crashed:
      return say(text::explain_crashed, {strsignal(given.answer.detail)});
    case Ending::timed_out:
      return say(text::explain_timed_out, {seconds(alone_limits)});
    case Ending::exited:
      return say(text::explain_exited, {std::to_string(given.answer.detail)});
    case Ending::malformed:
      return say(text::explain_malformed);
    case Ending::refused:
      return say(text::explain_refused);
    case Ending::out_of_memory:  // where somebody watches the memory; nobody does here
    case Ending::did_not_start:
      break;
  }
  return say(text::explain_did_not_start, {std::strerror(given.answer.detail)});
}

/// Why the picture did not come as far as the pixel.
std::string no_picture(const Given& given) {
  const std::string rows = std::to_string(given.answer.rows);
  switch (given.answer.ending) {
    case Ending::crashed:
      return say(text::explain_picture_crashed, {strsignal(given.answer.detail), rows});
    case Ending::timed_out:
      return say(text::explain_picture_timed_out, {seconds(picture_limits), rows});
    default:
      return say(text::explain_picture_ended, {rows});
  }
}

std::string color_text(const DecimalTriple& color) {
  return fmt::format("({}, {}, {})", color[0].text, color[1].text, color[2].text);
}

bool is_black(const SceneText& scene, int sphere) {
  const DecimalTriple& color = scene.spheres[static_cast<std::size_t>(sphere - 1)].color;
  return color[0].is_zero() && color[1].is_zero() && color[2].is_zero();
}

class Speaker {
 public:
  Speaker(const Subject& subject, const Chain& chain, const Comparison& comparison)
      : scene_(subject.scene),
        chain_(chain),
        comparison_(comparison),
        difference_(*comparison.difference) {}

  std::string say_why() const {
    switch (difference_.why) {
      case Why::no_answer:
        return where() + say(text::explain_why_no_answer);
      case Why::not_finite:
        return where() + say(text::explain_why_not_finite, {channels()});
      case Why::whole_numbers:
        return where() + say(text::explain_why_whole_numbers, {channels(), right_channels()});
      case Why::no_multiple:
        return where() +
               say(text::explain_why_no_multiple, {channels(), color_text(sphere_color())});
      case Why::plain_color:
        return say(text::explain_why_plain_color);
      case Why::not_alone:
        return "";  // said apart
      case Why::other_sphere:
        return say(text::explain_why_other_sphere,
                   {std::to_string(*comparison_.sphere), std::to_string(chain_.hit->sphere)});
      case Why::background_seen:
        return say(text::explain_why_background_seen,
                   {std::to_string(chain_.hit->sphere), decimal_text(chain_.hit->t)});
      case Why::sphere_seen:
        return say(text::explain_why_sphere_seen, {std::to_string(*comparison_.sphere)});
      default:
        return of_number();
    }
  }

 private:
  /// The question that the line is about.
  const Question& question() const {
    if (difference_.line == Line::ambient) return *comparison_.ambient;
    if (difference_.line == Line::light) return *comparison_.lights[difference_.light];
    return comparison_.whole();
  }
  /// Which lights the scene has that the line is about.
  std::string where() const {
    if (difference_.line == Line::ambient) return say(text::explain_with_ambient) + " ";
    if (difference_.line != Line::light) return say(text::explain_with_all) + " ";
    return say(text::explain_with_light, {std::to_string(difference_.light + 1)}) + " ";
  }
  std::string channels() const { return triple_text(question().given.channels); }
  std::string right_channels() const {
    LinearChannels right{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Interval& channel = question().expected.front().channels[i];
      right[i] = (channel.low + channel.high) / 2;
    }
    return triple_text(right);
  }
  const DecimalTriple& sphere_color() const {
    return scene_.spheres[static_cast<std::size_t>(chain_.hit->sphere - 1)].color;
  }

  /// Where I, or a term of it, is another number.
  std::string of_number() const {
    if (difference_.line == Line::color) {
      return say(text::explain_why_color, {channels(), triple_text(chain_.channels)});
    }
    if (difference_.line == Line::light) return of_term();
    const bool is_sum = difference_.line == Line::sum;
    const reference::Enclosure I_A = ambient_intensity();
    const Pair pair = told_apart(is_sum ? chain_.I : I_A, *question().I);
    return say(is_sum ? text::explain_why_sum : text::explain_why_ambient,
               {pair.yours, pair.right});
  }

  reference::Enclosure ambient_intensity() const {
    for (const LightText& light : scene_.lights) {
      if (light.kind != LightKind::ambient) continue;
      const mpq_class I_A = reference::to_exact(light.intensity);
      return {I_A, I_A};
    }
    return {0, 0};
  }

  std::string of_term() const {
    const std::string number = std::to_string(difference_.light + 1);
    const LightMet* met = nullptr;
    for (const LightMet& light : chain_.hit->lights) {
      if (light.index == difference_.light) met = &light;
    }
    const Pair pair = told_apart(met->term, *question().I);
    const std::string L = decimal_text(met->L_length);
    const auto sphere = static_cast<std::size_t>(chain_.hit->sphere - 1);
    switch (difference_.why) {
      case Why::behind:
        return say(text::explain_why_behind, {number, pair.yours});
      case Why::nothing:
        return say(text::explain_why_nothing, {number, pair.right});
      case Why::no_term:
        return say(text::explain_why_no_term, {number, decimal_text(question().I->value)});
      case Why::times_L:
        return say(text::explain_why_times_L, {number, pair.yours, pair.right, L});
      case Why::over_L:
        return say(text::explain_why_over_L, {number, pair.yours, pair.right, L});
      case Why::times_r:
        return say(text::explain_why_times_r,
                   {number, pair.yours, pair.right, scene_.spheres[sphere].radius.text});
      default:
        return say(text::explain_why_light, {number, pair.yours, pair.right});
    }
  }

  const SceneText& scene_;
  const Chain& chain_;
  const Comparison& comparison_;
  const Difference& difference_;
};

}  // namespace

std::vector<std::string> conclusion(const Subject& subject, const Chain& chain,
                                    const Comparison& comparison) {
  if (!comparison.answered()) return {no_answer(comparison.alone.given)};
  std::vector<std::string> out;
  const Question& whole = comparison.whole();
  if (comparison.difference) {
    const std::string why = Speaker(subject, chain, comparison).say_why();
    if (!why.empty()) out.push_back(why);
    if (!whole.differs()) out.push_back(say(text::explain_pixel_right));
  } else if (whole.standing == Standing::float_only) {
    out.push_back(say(text::explain_only_float));
  } else {
    const bool is_exact =
        whole.standing == Standing::right && comparison.sphere == whole.expected.front().sphere;
    out.push_back(say(is_exact ? text::explain_all_right : text::explain_all_accepted));
    if (chain.hit && subject.stage.terms != 0 && is_black(subject.scene, chain.hit->sphere)) {
      out.push_back(say(text::explain_black_sphere));
    }
  }
  const Question& picture = *comparison.in_picture;
  if (!picture.given.came()) {
    out.push_back(no_picture(picture.given));
  } else if (comparison.depends) {
    out.push_back(say(text::explain_depends, {triple_text(picture.given.channels, 17),
                                              triple_text(comparison.alone.given.channels, 17)}));
  }
  return out;
}

int exit_status(const Comparison& comparison) {
  const Ending alone = comparison.alone.given.answer.ending;
  if (alone == Ending::did_not_start) return 3;
  if (alone == Ending::refused) return 2;
  if (!comparison.answered() || comparison.difference) return 1;
  const Given& picture = comparison.in_picture->given;
  // That a large picture takes long is no mistake.
  return picture.came() || picture.answer.ending == Ending::timed_out ? 0 : 1;
}

Pair told_apart(const reference::Enclosure& right, const SeenI& yours) {
  constexpr int all_digits = 15;
  Pair pair;
  for (int digits = shown_digits; digits <= all_digits; digits += 2) {
    pair = {decimal_text(right, digits), decimal_text(yours.value, digits)};
    const reference::Enclosure middle{right.low, right.low};
    if (pair.yours != decimal_text(mpq_class(middle.low), digits)) break;
  }
  if (yours.at_least) pair.yours = say(text::explain_at_least, {pair.yours});
  return pair;
}

}  // namespace fos
