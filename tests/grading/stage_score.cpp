#include "stage_score.hpp"

#include <algorithm>

#include "fos/text.hpp"
#include "mistaken_answers.hpp"
#include "report.hpp"

namespace fos::grading {
namespace {

/// What is wrong with a frame.
Cause cause_in(const Verdict& verdict) {
  if (verdict.not_finite.pixels > 0) return Cause::not_finite;
  if (verdict.wrong.pixels > 0) return Cause::wrong_pixels;
  return verdict.unwritten.pixels > 0 ? Cause::unwritten : Cause::none;
}

CheckResult line_of(Part part, const Text& words) {
  CheckResult result;
  result.part = part;
  result.words_en = words.en;
  result.words_el = words.el;
  return result;
}

/// The public checks, as in `./lab check`, with why they fail.
std::vector<CheckResult> public_checks(const Questions& checks, const Findings& findings) {
  // The frame that is shown stands for all of them: NaN and unwritten pixels are told apart there.
  const Cause shown = findings.shown ? cause_in(findings.shown->verdict) : Cause::none;
  const Cause why = shown == Cause::none ? Cause::wrong_pixels : shown;
  std::vector<CheckResult> results;
  for (std::size_t i = 0; i < findings.list.size(); ++i) {
    const Finding& finding = findings.list[i];
    const bool is_check = i < checks.test().checks.size();
    const Text& words = is_check ? checks.test().checks[i].words : text::check_every_pixel;
    CheckResult result = line_of(Part::checks, words);
    result.passed = finding.passed;
    result.things = finding.things;
    result.why = finding.why;
    result.status = finding.passed == finding.things ? Status::passed : Status::failed;
    if (result.status == Status::failed) result.cause = why;
    results.push_back(std::move(result));
  }
  return results;
}

CheckResult drawn_scenes(const StageQuestions& questions, const std::vector<Asked>& answers) {
  CheckResult result = line_of(Part::scenes, text::grade_drawn);
  result.things = static_cast<int>(questions.drawn().size());
  for (std::size_t i = 0; i < questions.drawn().size(); ++i) {
    const Asked& asked = answers[questions.first_drawn() + i];
    const Cause cause =
        asked.is_whole() ? cause_in(questions.drawn()[i]->judge(*asked.frame)) : cause_of(asked);
    if (cause == Cause::none) ++result.passed;
    if (result.cause == Cause::none) result.cause = cause;
  }
  result.status = result.passed == result.things ? Status::passed : Status::failed;
  return result;
}

const Text& words(Relation relation) {
  switch (relation) {
    case Relation::mirrored:
      return text::grade_mirrored;
    case Relation::dimmed:
      return text::grade_dimmed;
    case Relation::reordered:
      break;
  }
  return text::grade_reordered;
}

CheckResult related(Relation relation, const StageQuestions& questions,
                    const std::vector<Asked>& answers) {
  CheckResult result = line_of(Part::relations, words(relation));
  result.status = Status::failed;
  const std::size_t base = StageQuestions::base_of(relation);
  const Asked& from = answers[questions.first_drawn() + base];
  const Asked& to = answers[questions.place(relation)];
  for (const Asked* asked : {&from, &to}) {
    if (result.cause == Cause::none && !asked->is_whole()) result.cause = cause_of(*asked);
  }
  if (result.cause != Cause::none) return result;
  const Judge& judge = *questions.drawn()[base];
  // A wrong picture can be mirrored too: what it shows must be right to begin with.
  result.cause = cause_in(judge.judge(*from.frame));
  if (result.cause == Cause::none &&
      !holds(relation, questions.stage().terms != 0, judge, *from.frame, *to.frame)) {
    result.cause = Cause::wrong_pixels;
  }
  if (result.cause == Cause::none) {
    result.status = Status::passed;
    result.passed = 1;
  }
  return result;
}

int percent_of(const Shares& shares, Part part) {
  return part == Part::checks   ? shares.checks
         : part == Part::scenes ? shares.scenes
                                : shares.relations;
}

/// Shares the stage's points out to the lines, each thing of a part alike. Hundredths are rounded
/// down, so that only what is whole gives all.
void give_points(StageResult& result, const Shares& shares) {
  long sum = 0;
  bool all = true;
  for (const Part part : parts) {
    long things = 0;
    for (const CheckResult& check : result.checks) {
      if (check.part == part) things += check.things;
    }
    for (CheckResult& check : result.checks) {
      if (check.part != part) continue;
      const long worth = long{result.most} * percent_of(shares, part);
      check.most = static_cast<int>(worth * check.things / (100 * things));
      check.points = static_cast<int>(worth * check.passed / (100 * things));
      sum += check.points;
      all = all && check.passed == check.things;
    }
  }
  result.points = all ? result.most : static_cast<int>(sum);
}

}  // namespace

Cause cause_of(const Asked& asked) {
  if (!asked.asked) return Cause::out_of_time;  // an answer before it never came
  switch (asked.answer.ending) {
    case Ending::complete:
      return Cause::none;
    case Ending::refused:
      return Cause::refused;
    case Ending::crashed:
      return Cause::crashed;
    case Ending::timed_out:
      return Cause::out_of_time;
    case Ending::out_of_memory:
      return Cause::out_of_memory;
    case Ending::exited:
    case Ending::malformed:
      return Cause::left;
    case Ending::did_not_start:
      break;
  }
  return Cause::infrastructure;
}

Findings examine_checks(const StageQuestions& questions, const std::vector<Asked>& answers) {
  const auto count = static_cast<std::ptrdiff_t>(questions.checks().scenes().size());
  return examine(questions.checks(), {answers.begin(), answers.begin() + count});
}

StageResult score(const StageQuestions& questions, const Findings& findings,
                  const std::vector<Asked>& answers, const Shares& shares) {
  StageResult result;
  result.stage = questions.stage().id;
  result.most = 100 * questions.stage().points;
  result.checks = public_checks(questions.checks(), findings);
  result.checks.push_back(drawn_scenes(questions, answers));
  for (const Relation relation : relations)
    result.checks.push_back(related(relation, questions, answers));
  give_points(result, shares);
  result.status = result.points == result.most ? Status::passed : Status::failed;
  for (const Asked& asked : answers) {
    if (!asked.is_whole() && result.cause == Cause::none) {
      result.cause = cause_of(asked);
      result.program = asked.printed.substr(0, most_text);
    }
  }
  return result;
}

void count_carried(StageResult& result, const StageQuestions& questions,
                   const std::vector<Asked>& answers, const Diagnosis& diagnosis,
                   const Shares& shares) {
  const MistakenAnswers mistaken(questions.stage(), diagnosis);
  StageResult counted = result;
  for (CheckResult& check : counted.checks) check.passed = 0;
  const auto is_mistaken = [&](std::size_t place) {
    return answers[place].is_whole() &&
           mistaken.gives(questions.scenes()[place], *answers[place].frame);
  };
  const std::vector<Check>& checks = questions.checks().test().checks;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const bool all = std::all_of(
        checks[i].pixels.begin(), checks[i].pixels.end(),
        [&](const PixelCase& pixel) { return is_mistaken(questions.checks().place(pixel)); });
    counted.checks[i].passed = all ? 1 : result.checks[i].passed;
  }
  CheckResult& whole = counted.checks[checks.size()];
  for (const auto& judge : questions.checks().judges())
    whole.passed += is_mistaken(questions.checks().place(*judge));
  CheckResult& drawn = counted.checks[checks.size() + 1];
  for (std::size_t i = 0; i < questions.drawn().size(); ++i)
    drawn.passed += is_mistaken(questions.first_drawn() + i);
  for (std::size_t i = 0; i < relations.size(); ++i) {
    CheckResult& each = counted.checks[checks.size() + 2 + i];
    each.passed = is_mistaken(questions.place(relations[i])) ? 1 : 0;
  }
  give_points(counted, shares);
  if (counted.points <= result.points) return;
  result.points = counted.points;
  result.carried = true;
}

}  // namespace fos::grading
