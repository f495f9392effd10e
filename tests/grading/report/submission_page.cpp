#include "submission_page.hpp"

#include <algorithm>

#include "clean_text.hpp"
#include "fos/text.hpp"
#include "page_frame.hpp"
#include "report_words.hpp"
#include "stage_section.hpp"
#include "summary.hpp"

namespace fos::grading {
namespace {

void add_list(MarkupWriter& out, const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  out.element("h2", title).raw("\n<ul>\n");
  for (const std::string& line : lines) out.element("li", "words", line).raw("\n");
  out.raw("</ul>\n");
}

void add_overview(MarkupWriter& out, const SubmissionResult& submission) {
  out.raw(R"(<table id="overview"><thead><tr><th scope="col">)").text(say(text::report_stage));
  out.raw(R"(</th><th scope="col">)").text(say(text::report_result));
  out.raw(R"(</th><th scope="col" class="number">)").text(say(text::report_points_heading));
  out.raw("</th></tr></thead>\n<tbody>\n");
  for (std::size_t i = 0; i < submission.stages.size(); ++i) {
    const StageResult& stage = submission.stages[i];
    const int points = points_of(submission, stage);
    out.raw(R"(<tr><th scope="row"><a)").attribute("href", "#stage-" + std::to_string(i + 1));
    out.raw(">").text(stage_title(stage.stage)).raw("</a></th><td>");
    add_status(out, stage);
    add_meter(out, points, stage.most);
    out.raw(R"(</td><td class="number">)").text(points_of_most(points, stage.most));
    out.raw("</td></tr>\n");
  }
  out.raw("</tbody></table>\n");
}

}  // namespace

std::string submission_page(const Run& run, const SubmissionResult& submission) {
  const std::string shown_name = submission.name.empty() ? submission.id : submission.name;
  const Summary summary = summarize(submission);
  MarkupWriter out;
  out.raw("<header>\n<p class=\"dim\">").text(run.title).raw("</p>\n<h1><bdi>");
  out.text(shown_name).raw("</bdi></h1>\n");
  if (!submission.username.empty()) {
    out.raw(R"(<p class="dim"><bdi>)").text(submission.username).raw("</bdi></p>\n");
  }
  out.raw(R"(<ul class="facts"><li><strong id="total">)");
  out.text(points_of_most(submission.points(), submission.most())).raw("</strong>");
  out.text(say(text::report_total));
  out.raw("</li></ul>\n");
  if (!is_settled(summary)) {
    out.raw(R"(<p id="not-settled"><strong>)").text(say(text::report_not_settled));
    out.raw("</strong></p>\n");
  }
  out.raw("</header>\n<main>\n");
  std::vector<std::string> marks;
  for (const Override& own : submission.overrides) marks.push_back(override_words(own));
  add_list(out, say(text::report_own_marks), marks);
  add_list(out, say(text::report_hand_in), submission.notes);
  add_overview(out, submission);
  for (std::size_t i = 0; i < submission.stages.size(); ++i) {
    add_stage_section(out, static_cast<int>(i) + 1, submission, submission.stages[i],
                      shown(run.feedback));
  }
  out.raw("</main>\n<footer class=\"dim\">\n<p>");
  out.text(graded_with(run, submission.seed, submission.box)).raw("</p>\n<p>");
  out.text(say(text::report_source, {submission.source})).raw(" · ");
  out.text(say(text::report_key, {submission.key})).raw("</p>\n</footer>\n");
  return whole_page(one_line(shown_name + " · " + run.title), out, false);
}

}  // namespace fos::grading
