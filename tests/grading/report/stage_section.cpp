#include "stage_section.hpp"

#include <algorithm>

#include "escape.hpp"
#include "fos/text.hpp"
#include "page_frame.hpp"

namespace fos::grading {
namespace {

std::string_view tone_of(Status status) {
  return status == Status::passed ? "good" : status == Status::failed ? "bad" : "none";
}

void add_mark(MarkupWriter& out, Status status) {
  out.raw(R"(<span role="img")").attribute("class", tone_of(status));
  out.attribute("aria-label", status_words(status)).raw(">").text(mark(status)).raw("</span>");
}

void add_check(MarkupWriter& out, const StageResult& stage, const CheckResult& check,
               const Shown& what, bool with_points) {
  out.raw(R"(<tr><td class="narrow">)");
  add_mark(out, check.status);
  out.raw("</td><td>").text(check_words(check));
  if (const std::string why = check_why(stage, check, what); !why.empty()) {
    out.raw(R"(<div class="dim words">)").text(why).raw("</div>");
  }
  out.raw("</td>");
  if (with_points) {
    out.raw(R"(<td class="number">)");
    if (check.most > 0) out.text(points_of_most(check.points, check.most));
    out.raw("</td>");
  }
  out.raw("</tr>\n");
}

void add_checks(MarkupWriter& out, const StageResult& stage, const Shown& what) {
  const bool with_points = std::any_of(stage.checks.begin(), stage.checks.end(),
                                       [](const CheckResult& check) { return check.most > 0; });
  for (const Part part : parts) {
    const auto is_of_part = [&](const CheckResult& check) { return check.part == part; };
    if (std::none_of(stage.checks.begin(), stage.checks.end(), is_of_part)) continue;
    out.element("h3", part_title(part)).raw("\n<table class=\"checks\"><tbody>\n");
    for (const CheckResult& check : stage.checks) {
      if (is_of_part(check)) add_check(out, stage, check, what, with_points);
    }
    out.raw("</tbody></table>\n");
  }
}

void add_advice(MarkupWriter& out, const StageResult& stage, const Shown& what) {
  const bool named = what.mistake && !stage.mistake.empty();
  const bool asked = what.question && !stage.advice.empty();
  if (!named && !asked) return;
  out.raw(R"(<div class="advice">)");
  if (named) {
    out.raw("<p>").text(say(text::report_mistake_found)).raw(" ");
    out.raw(R"(<strong class="mistake">)").text(stage.mistake).raw("</strong></p>");
  }
  if (asked) {
    out.element("h3", say(text::report_hint)).raw(R"(<p class="words">)").text(stage.advice);
    out.raw("</p>");
  }
  out.raw("</div>\n");
}

void add_pictures(MarkupWriter& out, const StageResult& stage) {
  struct Kind {
    const Text* caption;
    const Text* description;
  };
  constexpr Kind kinds[] = {{&text::report_yours, &text::report_picture_yours},
                            {&text::report_expected, &text::report_picture_expected},
                            {&text::report_difference, &text::report_picture_difference}};
  if (stage.pictures.empty()) return;
  out.raw("<div class=\"pictures\">\n");
  for (std::size_t i = 0; i < std::min(stage.pictures.size(), std::size(kinds)); ++i) {
    if (stage.pictures[i].empty()) continue;
    out.raw(R"(<figure><img loading="lazy")").attribute("src", address(stage.pictures[i]));
    out.attribute("alt", say(*kinds[i].description, {stage_title(stage.stage)})).raw(">");
    out.element("figcaption", say(*kinds[i].caption)).raw("</figure>\n");
  }
  out.raw("</div>\n");
}

void add_output(MarkupWriter& out, const std::string& title, const std::string& words, bool open) {
  if (words.empty()) return;
  // The line feed behind <pre> is not part of its text, so that a first one of the words stays.
  out.raw("<details");
  if (open) out.raw(" open");
  out.raw(">").element("summary", title).raw("<pre tabindex=\"0\">\n").text(words);
  out.raw("</pre></details>\n");
}

}  // namespace

void add_status(MarkupWriter& out, const StageResult& stage) {
  const bool partly = stage.status == Status::failed && stage.points > 0;
  out.raw("<span").attribute("class", partly ? "part" : tone_of(stage.status)).raw(">");
  out.text(mark(stage.status)).raw(" ");
  out.text(partly ? say(text::report_partly) : status_words(stage.status)).raw("</span>");
}

void add_stage_section(MarkupWriter& out, int number, const SubmissionResult& submission,
                       const StageResult& stage, const Shown& what) {
  out.raw(R"(<section class="stage")").attribute("id", "stage-" + std::to_string(number));
  out.raw(">\n<h2><span>").text(stage_title(stage.stage)).raw("</span><span>");
  out.text(points_of_most(points_of(submission, stage), stage.most)).raw("</span></h2>\n<p>");
  add_status(out, stage);
  out.raw("</p>\n");
  if (const std::string notes = stage_notes(stage); !notes.empty()) {
    out.raw(R"(<p class="words">)").text(notes).raw("</p>\n");
  }
  add_output(out, say(text::report_compiler), stage.compiler, stage.cause == Cause::not_compiled);
  add_advice(out, stage, what);
  if (what.pictures) add_pictures(out, stage);
  add_checks(out, stage, what);
  if (what.question) {
    add_output(out, say(text::report_program), stage.program, false);
    add_output(out, say(text::report_sanitizer), stage.sanitizer, false);
  }
  out.raw("</section>\n");
}

}  // namespace fos::grading
