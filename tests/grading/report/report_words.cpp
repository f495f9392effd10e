#include "report_words.hpp"

#include "clean_text.hpp"
#include "fos/stage_list.hpp"
#include "fos/text.hpp"

namespace fos::grading {
namespace {

/// Words of a student, each line marked as such: none can be taken for one of ours.
std::string quoted(std::string_view title, std::string_view words) {
  std::string out = std::string(title) + ":\n  | ";
  std::string lines = clean(words);
  while (lines.ends_with('\n')) lines.pop_back();
  for (const char c : lines) {
    out += c;
    if (c == '\n') out += "  | ";
  }
  return out;
}

}  // namespace

Shown shown(Feedback feedback) {
  const bool full = feedback == Feedback::full;
  return {feedback != Feedback::marks, full, full, full};
}

std::string stage_title(std::string_view id) {
  for (const Stage& stage : stages) {
    if (stage.id == id) return say(stage.name);
  }
  return std::string(id);
}

std::string part_title(Part part) {
  switch (part) {
    case Part::checks:
      return say(text::report_checks);
    case Part::scenes:
      return say(text::report_scenes);
    case Part::relations:
      break;
  }
  return say(text::report_relations);
}

std::string cause_words(Cause cause) {
  switch (cause) {
    case Cause::none:
      return "";
    case Cause::wrong_pixels:
      return say(text::report_wrong_pixels);
    case Cause::not_finite:
      return say(text::report_not_finite);
    case Cause::unwritten:
      return say(text::report_unwritten);
    case Cause::crashed:
      return say(text::report_crashed);
    case Cause::out_of_time:
      return say(text::report_out_of_time);
    case Cause::out_of_memory:
      return say(text::report_out_of_memory);
    case Cause::left:
      return say(text::report_left);
    case Cause::refused:
      return say(text::report_refused);
    case Cause::not_compiled:
      return say(text::report_not_compiled);
    case Cause::no_file:
      return say(text::report_no_file);
    case Cause::infrastructure:
      break;
  }
  return say(text::report_infrastructure);
}

std::string status_words(Status status) {
  switch (status) {
    case Status::passed:
      return say(text::report_passed);
    case Status::failed:
      return say(text::report_failed);
    case Status::not_judged:
      break;
  }
  return say(text::report_not_judged);
}

std::string_view mark(Status status) {
  switch (status) {
    case Status::passed:
      return "✓";
    case Status::failed:
      return "✗";
    case Status::not_judged:
      break;
  }
  return "–";
}

std::string box_words(std::string_view box) {
  return say(text::report_box, {box == "none" ? say(text::report_unboxed) : std::string(box)});
}

std::string graded_with(const Run& run, std::uint64_t seed, std::string_view box) {
  std::string date = run.date;  // ISO 8601: a space reads better than its T
  if (date.size() > 10 && date[10] == 'T') date[10] = ' ';
  return say(text::report_made, {date}) + " · " + say(text::report_toolkit, {run.toolkit}) + " · " +
         say(text::report_seed, {std::to_string(seed)}) + " · " + box_words(box);
}

std::string points_of_most(int points, int most) {
  return points_text(points) + " / " + points_text(most);
}

std::string check_title(const CheckResult& check) {
  return language() == Language::el ? check.words_el : check.words_en;
}

std::string check_words(const CheckResult& check) {
  if (check.things < 2 || check.passed == check.things) return check_title(check);
  return check_title(check) + " " +
         say(text::check_of, {std::to_string(check.passed), std::to_string(check.things)});
}

std::string check_why(const StageResult& stage, const CheckResult& check, const Shown& what) {
  if (check.status == Status::passed) return "";
  if (what.why && !check.why.empty()) return check.why;
  const bool is_plain = check.cause == Cause::wrong_pixels || check.cause == stage.cause;
  return is_plain ? "" : cause_words(check.cause);
}

std::string stage_notes(const StageResult& stage) {
  std::string out = cause_words(stage.cause);
  if (stage.status == Status::not_judged) {
    if (!out.empty()) out += "\n";
    out += say(text::report_stage_not_judged);
  }
  if (stage.carried) {
    if (!out.empty()) out += "\n";
    out += say(text::report_carried);
  }
  return out;
}

std::string stage_text(const StageResult& stage, const Shown& what) {
  std::string out;
  const auto line = [&](std::string_view words) {
    if (!words.empty()) out.append(words).append("\n");
  };
  line(stage_notes(stage));
  for (const CheckResult& check : stage.checks) {
    std::string words = std::string(mark(check.status)) + " " + check_words(check);
    if (check.most > 0) words += "  " + points_of_most(check.points, check.most);
    line(words);
    if (const std::string why = check_why(stage, check, what); !why.empty()) line("  " + why);
  }
  if (what.mistake) line(stage.mistake);
  if (what.question) line(stage.advice);
  if (!stage.compiler.empty()) line(quoted(say(text::report_compiler), stage.compiler));
  if (what.question && !stage.program.empty()) {
    line(quoted(say(text::report_program), stage.program));
  }
  if (what.question && !stage.sanitizer.empty()) {
    line(quoted(say(text::report_sanitizer), stage.sanitizer));
  }
  return clean(out);
}

std::string override_words(const Override& own) {
  const std::string points = points_text(own.points);
  if (own.stage.empty()) return say(text::report_override_all, {points, own.reason});
  return say(text::report_override, {stage_title(own.stage), points, own.reason});
}

std::string comment(Feedback feedback, const Summary& summary) {
  std::string out = "Fos:";
  for (const StageSummary& stage : summary.stages) {
    if (out.back() != ':') out += " ·";
    out += " " + stage_title(stage.stage) + " " + points_of_most(stage.points, stage.most);
    const std::string why = shown(feedback).mistake && !stage.mistake.empty()
                                ? stage.mistake
                                : cause_words(stage.cause);
    if (stage.status != Status::passed && !why.empty()) out += " (" + why + ")";
  }
  for (const Override& own : summary.overrides) out += " · " + override_words(own);
  return one_line(shortened(out, 2000));
}

}  // namespace fos::grading
