#include "escape.hpp"
#include "fos/text.hpp"
#include "platforms.hpp"
#include "report_words.hpp"

namespace fos::grading {
namespace {

/// What GitHub takes of a step: 1 MiB of an output, 1 MiB of a summary.
constexpr std::size_t most_of_a_step = 1024UL * 1024;

void add_block(std::string& out, const std::string& title, const std::string& words) {
  if (words.empty()) return;
  out += "<details><summary>" + markdown(title) + "</summary>\n\n<pre>" + markdown_block(words) +
         "</pre>\n\n</details>\n\n";
}

/// The words about the checks of a stage that is not all right.
void add_stage(std::string& out, const StageResult& stage, const Shown& what) {
  out += "### " + markdown(stage_title(stage.stage)) + "\n\n";
  if (const std::string notes = stage_notes(stage); !notes.empty()) out += markdown(notes) + "\n\n";
  for (const CheckResult& check : stage.checks) {
    out += "- " + std::string(mark(check.status)) + " " + markdown(check_words(check));
    if (check.most > 0) out += ", " + points_of_most(check.points, check.most);
    if (const std::string why = check_why(stage, check, what); !why.empty()) {
      out += "<br>" + markdown(why);
    }
    out += "\n";
  }
  out += "\n";
  if (what.mistake && !stage.mistake.empty()) out += "**" + markdown(stage.mistake) + "**\n\n";
  if (what.question && !stage.advice.empty()) out += markdown(stage.advice) + "\n\n";
  add_block(out, say(text::report_compiler), stage.compiler);
  if (!what.question) return;
  add_block(out, say(text::report_program), stage.program);
  add_block(out, say(text::report_sanitizer), stage.sanitizer);
}

}  // namespace

std::string actions_summary(const Run& run, const SubmissionResult& submission) {
  std::string out = "## " + markdown(run.title) + "\n\n";
  out +=
      "**" +
      say(text::report_points, {points_text(submission.points()), points_text(submission.most())}) +
      "**\n\n";
  if (!is_settled(summarize(submission))) out += markdown(say(text::report_not_settled)) + "\n\n";
  out += "| | " + markdown(say(text::report_stage)) + " | " +
         markdown(say(text::report_points_heading)) + " |\n|---|---|---|\n";
  for (const StageResult& stage : submission.stages) {
    out += "| " + std::string(mark(stage.status)) + " | " + markdown(stage_title(stage.stage)) +
           " | " + points_of_most(points_of(submission, stage), stage.most) + " |\n";
  }
  out += "\n";
  for (const Override& own : submission.overrides)
    out += "- " + markdown(override_words(own)) + "\n";
  for (const std::string& note : submission.notes) out += "- " + markdown(note) + "\n";
  if (!submission.overrides.empty() || !submission.notes.empty()) out += "\n";
  for (const StageResult& stage : submission.stages) {
    if (stage.status != Status::passed) add_stage(out, stage, shown(run.feedback));
  }
  out += markdown(say(text::report_toolkit, {run.toolkit})) + ", " +
         markdown(say(text::report_seed, {std::to_string(submission.seed)})) + ", " +
         markdown(box_words(submission.box)) + "\n";
  return out;
}

Objections actions_preflight(const Run& run, const SubmissionResult& submission) {
  Objections out;
  const auto object = [&](std::string words) {
    out.push_back({submission.id, std::move(words), false});
  };
  if (!is_settled(summarize(submission))) object(say(text::report_no_mark));
  // The reporter leaves out what is worth nothing.
  if (submission.most() <= 0) object(say(text::report_nothing_to_give));
  for (const std::size_t size :
       {actions_output(run, submission).size(), actions_summary(run, submission).size()}) {
    if (size > most_of_a_step) {
      object(say(text::report_too_large, {std::to_string(size), std::to_string(most_of_a_step)}));
    }
  }
  return out;
}

}  // namespace fos::grading
