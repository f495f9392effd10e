// One question to a stage program, and how the answer stands to the right ones.
#pragma once

#include <optional>
#include <vector>

#include "asked_pixel.hpp"
#include "hue.hpp"
#include "judge.hpp"

namespace fos {

/// How an answer stands to the right ones (judge.hpp has the rule).
enum class Standing {
  right,
  float_only,  ///< right to float precision only
  not_judged,  ///< rounding may change the answer by any amount
  wrong,
  not_finite,
  unwritten,
  no_answer,  ///< the program crashed, took too long, …
};

/// One scene that the program was asked about, and what it gave for the pixel.
struct Question {
  Given given;
  Standing standing = Standing::no_answer;
  std::vector<Expected> expected;  ///< the right answers, the exact one first
  std::optional<SeenI> I;  ///< where the color is a multiple of that of the sphere in question

  bool differs() const { return standing >= Standing::wrong; }
};

/// What `judge`, one of a single pixel, makes of it.
Question judged(Given given, const Judge& judge);

/// The sphere of the right answer that was given, if one was.
std::optional<int> accepted_sphere(const Question& question);

/// Whether the channels are the right ones, cut or rounded to whole numbers.
bool are_cut(const Question& question);

}  // namespace fos
