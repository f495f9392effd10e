// A program's answers beside the right ones, up to the first line of the chain that differs.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "chain.hpp"
#include "fos/stage_list.hpp"
#include "question.hpp"
#include "right_answers.hpp"

namespace fos {

/// The lines of the chain that show from outside, in this order.
enum class Line { sphere, ambient, light, sum, color };

/// What can be said of the line that differs, each a fact and no guess.
enum class Why {
  different,
  no_answer,
  not_finite,
  whole_numbers,    ///< the right channels, cut or rounded to whole numbers
  no_multiple,      ///< the channels are not one number times the color
  plain_color,      ///< the color as it is, whatever the light
  not_alone,        ///< right for the ray alone, wrong in the picture
  behind,           ///< a term where the light is behind the surface
  nothing,          ///< no term where there is one
  no_term,          ///< a term that this stage does not have
  times_L,          ///< |L| times the right term
  over_L,           ///< the right term over |L|
  times_r,          ///< r times the right term
  other_sphere,     ///< the color of another sphere
  background_seen,  ///< the background where a sphere is
  sphere_seen,      ///< a sphere where the background is
};

struct Difference {
  Line line = Line::sphere;
  Why why = Why::different;
  std::size_t light = 0;  ///< of Line::light: its index in SceneText::lights
};

/// Asks about a scene; the answer is for the pixel in question.
using Ask = std::function<Given(const SceneText&)>;

struct Comparison {
  Question alone;                               ///< the whole scene, the pixel's ray by itself
  std::optional<Question> in_picture;           ///< the same as a part of the picture
  std::optional<Question> ambient;              ///< the ambient light and no other
  std::vector<std::optional<Question>> lights;  ///< each light and no other, by its index
  Hue hue;                                      ///< of what told the sphere
  /// The sphere that the program sees as far as its color tells; 0: the background; nothing:
  /// the color is no sphere's, or there was no answer.
  std::optional<int> sphere;
  bool depends = false;  ///< the ray has another answer alone than in the picture
  std::optional<Difference> difference;

  /// What the person sees: the answer in the picture, where that came.
  const Question& whole() const {
    return in_picture && in_picture->given.came() ? *in_picture : alone;
  }
  /// There is something to compare.
  bool answered() const { return alone.given.came() && !alone.given.unwritten; }
};

/// Asks as few questions as lead to the first difference.
Comparison compare(const SceneText& scene, const Stage& stage, const Chain& chain,
                   const RightAnswers& right, const Ask& ask_alone, const Ask& ask_in_picture);

/// Whether a light is one of the stage's terms.
bool is_term(const Stage& stage, LightKind kind);

}  // namespace fos
