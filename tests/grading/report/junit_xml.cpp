// XML by our own writer: the file has six elements, and no library in Debian keeps out the
// characters that XML 1.0 forbids, which is all that is difficult here.
#include <fmt/core.h>

#include <algorithm>

#include "clean_text.hpp"
#include "fos/text.hpp"
#include "markup_writer.hpp"
#include "platforms.hpp"
#include "report_words.hpp"

namespace fos::grading {
namespace {

void property(MarkupWriter& out, std::string_view name, std::string_view value) {
  out.raw("      <property").attribute("name", name).attribute("value", value).raw("/>\n");
}

/// What the schema wants: seconds, and no points.
void add_counts(MarkupWriter& out, long tests, long failures, long errors, long skipped,
                double seconds) {
  out.attribute("tests", tests)
      .attribute("failures", failures)
      .attribute("errors", errors)
      .attribute("skipped", skipped)
      .attribute("time", fmt::format("{:.3f}", seconds));
}

/// A case of a stage: its name, how it ended, and why.
struct Case {
  std::string name;
  Status status = Status::not_judged;
  bool is_error = false;  ///< there was no picture to judge
  std::string kind;
  std::string why;
};

std::vector<Case> cases_of(const StageResult& stage, const Shown& what) {
  std::vector<Case> out;
  for (const CheckResult& check : stage.checks) {
    const bool no_frame = check.cause == Cause::crashed || check.cause == Cause::out_of_time ||
                          check.cause == Cause::out_of_memory || check.cause == Cause::left;
    // The name is the same in every run, so that readers can follow a case through them.
    std::string why = check_why(stage, check, what);
    if (why.empty()) {
      const std::string kind = cause_words(check.cause);
      why = check_words(check) + ": " + (kind.empty() ? status_words(check.status) : kind);
    }
    out.push_back(
        {check_title(check), check.status, no_frame, std::string(name(check.cause)), why});
  }
  // Where nothing could be checked the stage itself is the case, so that it is not missing.
  if (out.empty()) {
    out.push_back({stage_title(stage.stage), stage.status, stage.cause == Cause::not_compiled,
                   std::string(name(stage.cause)), stage_notes(stage)});
  }
  return out;
}

void add_case(MarkupWriter& out, const std::string& stage, const Case& one) {
  out.raw("    <testcase")
      .attribute("classname", stage)
      .attribute("name", one_line(one.name))
      .attribute("time", "0");
  if (one.status == Status::passed) {
    out.raw("/>\n");
    return;
  }
  out.raw(">\n");
  const std::string why = one_line(one.why.empty() ? status_words(one.status) : one.why);
  if (one.status == Status::not_judged) {
    out.raw("      <skipped").attribute("message", why).raw("/>\n");
  } else if (one.is_error) {
    out.raw("      <error").attribute("message", why).attribute("type", one.kind).raw("/>\n");
  } else {
    out.raw("      <failure").attribute("message", why).attribute("type", one.kind).raw(">");
    out.text(one.why).raw("</failure>\n");
  }
  out.raw("    </testcase>\n");
}

}  // namespace

std::string junit_xml(const Run& run, const SubmissionResult& submission) {
  MarkupWriter suites;
  long all[4] = {};
  double seconds = 0;
  for (const StageResult& stage : submission.stages) {
    const std::vector<Case> cases = cases_of(stage, shown(run.feedback));
    const auto count = [&](auto&& is) {
      return static_cast<long>(std::count_if(cases.begin(), cases.end(), is));
    };
    const long counts[] = {
        static_cast<long>(cases.size()),
        count([](const Case& one) { return one.status == Status::failed && !one.is_error; }),
        count([](const Case& one) { return one.status == Status::failed && one.is_error; }),
        count([](const Case& one) { return one.status == Status::not_judged; })};
    for (int i = 0; i < 4; ++i) all[i] += counts[i];
    seconds += stage.cpu_seconds;

    suites.raw("  <testsuite").attribute("name", stage.stage);
    add_counts(suites, counts[0], counts[1], counts[2], counts[3], stage.cpu_seconds);
    suites.attribute("hostname", "box").attribute("timestamp", run.date);
    suites.raw(">\n    <properties>\n");
    property(suites, "points", points_text(points_of(submission, stage)));
    property(suites, "most", points_text(stage.most));
    suites.raw("    </properties>\n");
    for (const Case& one : cases) add_case(suites, stage.stage, one);
    suites.raw("    <system-out>").text(stage_text(stage, shown(run.feedback)));
    suites.raw("</system-out>\n  </testsuite>\n");
  }
  MarkupWriter out;
  out.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites");
  out.attribute("name", run.title);
  add_counts(out, all[0], all[1], all[2], all[3], seconds);
  out.raw(">\n").add(suites).raw("</testsuites>\n");
  return out.str();
}

Objections junit_preflight(const SubmissionResult& submission) {
  Objections out;
  if (!is_settled(summarize(submission))) {
    out.push_back({submission.id, say(text::report_no_mark), false});
  }
  if (submission.stages.empty()) {
    out.push_back({submission.id, say(text::report_nothing_to_give), false});
  }
  return out;
}

}  // namespace fos::grading
