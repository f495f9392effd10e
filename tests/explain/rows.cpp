#include "rows.hpp"

#include <fmt/core.h>

#include "conclusion.hpp"
#include "fos/text.hpp"
#include "number_text.hpp"

namespace fos {
namespace {

using reference::Enclosure;

std::string written(const DecimalTriple& triple) {
  return fmt::format("({}, {}, {})", triple[0].text, triple[1].text, triple[2].text);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : ", ") + part;
  return out;
}

class Rows {
 public:
  Rows(Page& page, const Subject& subject, const Chain& chain, const Comparison* comparison)
      : page_(page),
        subject_(subject),
        scene_(subject.scene),
        chain_(chain),
        comparison_(comparison) {}

  void operator()() {
    if (!sphere()) return;
    if (chain_.hit && subject_.stage.terms != 0 && !light()) return;
    color();
  }

 private:
  bool differs_at(Line line) const {
    return comparison_ != nullptr && comparison_->difference &&
           comparison_->difference->line == line;
  }

  /// What does not show from outside.
  void unseen(std::string_view name, std::string_view value) {
    page_.row(name, value, "", comparison_ != nullptr ? Mark::unseen : Mark::none);
  }

  /// A row of I or a term of it. Returns whether the next may follow.
  bool number(std::string_view name, const Enclosure& right, const std::string& right_text,
              const Question* question, bool differs) {
    if (comparison_ == nullptr) {
      page_.row(name, right_text, "", Mark::none);
    } else if (question == nullptr || (!question->I && !differs)) {
      page_.row(name, right_text, "", Mark::unseen);
    } else if (!question->I) {
      page_.row(name, right_text, "?", Mark::different);
    } else if (differs) {
      const Pair pair = told_apart(right, *question->I);
      page_.row(name, right_text == decimal_text(right) ? pair.right : right_text, pair.yours,
                Mark::different);
    } else {
      const std::string yours = decimal_text(question->I->value);
      page_.row(name, right_text,
                question->I->at_least ? say(text::explain_at_least, {yours}) : yours,
                question->standing == Standing::not_judged ? Mark::open : Mark::same);
    }
    return !differs;
  }

  bool sphere() {
    if (comparison_ != nullptr) {
      page_.row("", say(text::explain_heading_right), " " + say(text::explain_heading_yours),
                Mark::none);
    }
    const int right = chain_.hit ? chain_.hit->sphere : 0;
    const std::string name =
        chain_.hit ? fmt::format("{}  {}", right,
                                 written(scene_.spheres[static_cast<std::size_t>(right - 1)].color))
                   : say(text::explain_background);
    const bool differs = differs_at(Line::sphere);
    if (comparison_ == nullptr || !comparison_->sphere) {
      unseen(say(text::explain_sphere), name);
    } else {
      const int yours = *comparison_->sphere;
      page_.row(say(text::explain_sphere), name,
                yours == 0 ? say(text::explain_background) : std::to_string(yours),
                differs ? Mark::different : Mark::same);
    }
    if (differs || !chain_.hit) return !differs;
    unseen(chain_.hit->root == 0 ? "t = t1" : "t = t2", decimal_text(chain_.hit->t));
    unseen("P = O + tD", triple_text(chain_.hit->P));
    unseen("N = CP/|CP|", triple_text(chain_.hit->N));
    if (subject_.stage.terms == 0) {
      page_.line();
      page_.paragraph(say(text::explain_no_light));
    }
    return true;
  }

  bool light() {
    page_.line();
    Enclosure I_A{0, 0};
    std::string I_A_text = say(text::explain_no_ambient);
    for (const LightText& light : scene_.lights) {
      if (light.kind != LightKind::ambient) continue;
      I_A.low = I_A.high = reference::to_exact(light.intensity);
      I_A_text = decimal_text(I_A);
    }
    const Question* ambient =
        comparison_ != nullptr && comparison_->ambient ? &*comparison_->ambient : nullptr;
    if (!number(say(text::explain_I_A), I_A, I_A_text, ambient, differs_at(Line::ambient))) {
      return false;
    }
    std::vector<std::string> others;
    for (const LightMet& met : chain_.hit->lights) {
      const bool differs = differs_at(Line::light) && comparison_->difference->light == met.index;
      if (is_term(subject_.stage, scene_.lights[met.index].kind)) {
        if (!term(met, differs)) return false;
      } else if (differs) {
        return number(say(text::explain_other_light, {std::to_string(met.index + 1)}), {0, 0}, "0",
                      question(met), true);
      } else {
        others.push_back(say(text::explain_light_name, {std::to_string(met.index + 1)}));
      }
    }
    page_.line();
    if (!others.empty()) page_.paragraph(say(text::explain_other_lights, {joined(others)}));
    return number(say(text::explain_I), chain_.I, decimal_text(chain_.I),
                  comparison_ != nullptr ? &comparison_->whole() : nullptr, differs_at(Line::sum));
  }

  const Question* question(const LightMet& met) const {
    if (comparison_ == nullptr || !comparison_->lights[met.index]) return nullptr;
    return &*comparison_->lights[met.index];
  }

  bool term(const LightMet& met, bool differs) {
    const LightText& light = scene_.lights[met.index];
    const bool is_point = light.kind == LightKind::point;
    const std::string number_text = std::to_string(met.index + 1);
    page_.line();
    page_.line(say(is_point ? text::explain_point_light : text::explain_directional_light,
                   {number_text, light.intensity.text, written(light.vector)}));
    unseen(say(is_point ? text::explain_point_L : text::explain_directional_L), triple_text(met.L));
    std::string right = decimal_text(met.term);
    if (met.shine == Shine::at_P) {
      right = say(text::explain_at_P);
    } else {
      unseen("⟨N,L⟩", decimal_text(met.N_dot_L));
      unseen("|L|", decimal_text(met.L_length));
      unseen("cos = ⟨N,L⟩/(|N||L|)",
             fmt::format("{}  ({}°)", decimal_text(met.cosine), decimal_text(met.degrees, 4)));
      if (met.shine == Shine::behind) right = say(text::explain_behind);
      if (met.shine == Shine::grazing) right = say(text::explain_grazing);
    }
    return number("I_" + number_text + " cos", met.term, right, question(met), differs);
  }

  void color() {
    const bool differs = differs_at(Line::color);
    const bool flat = !chain_.hit || subject_.stage.terms == 0;
    const std::string name = say(flat ? text::explain_flat_color : text::explain_color);
    const auto& [r, g, b] = chain_.bytes;
    const std::string bytes = fmt::format("{} {} {}", r, g, b);
    if (comparison_ == nullptr) {
      page_.row(name, triple_text(chain_.channels), "", Mark::none);
      page_.row(say(text::explain_byte), bytes, "", Mark::none);
      return;
    }
    const Question& whole = comparison_->whole();
    const LinearChannels& yours = whole.given.channels;
    const Mark mark = differs                                  ? Mark::different
                      : whole.standing == Standing::not_judged ? Mark::open
                                                               : Mark::same;
    page_.row(name, triple_text(chain_.channels), "", Mark::none);
    page_.row(say(text::explain_your_color), triple_text(yours), "", mark);
    if (differs) return;
    page_.row(say(text::explain_byte), bytes,
              fmt::format("{} {} {}", to_byte(yours[0]), to_byte(yours[1]), to_byte(yours[2])),
              mark);
  }

  Page& page_;
  const Subject& subject_;
  const SceneText& scene_;
  const Chain& chain_;
  const Comparison* comparison_;
};

}  // namespace

void write_rows(Page& page, const Subject& subject, const Chain& chain,
                const Comparison* comparison) {
  Rows(page, subject, chain, comparison)();
}

}  // namespace fos
