// Everything that is JSON: the one file that includes the library for it, for it takes the compiler
// seconds.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "clean_text.hpp"
#include "escape.hpp"
#include "fos/text.hpp"
#include "json.hpp"
#include "platforms.hpp"
#include "report_words.hpp"

namespace fos::grading {
namespace {

using Json = nlohmann::ordered_json;

/// A number of points: 22.5, or 20 where it is whole.
Json number(int hundredths) {
  if (hundredths % 100 == 0) return hundredths / 100;
  return hundredths / 100.0;
}

std::string dump(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

bool is_marked(const SubmissionResult& submission, const std::string& stage) {
  return std::ranges::any_of(submission.overrides,
                             [&](const Override& own) { return own.stage == stage; });
}

/// Whether the stage's points are final.
bool has_points(const SubmissionResult& submission, const StageResult& stage) {
  return stage.status != Status::not_judged || is_marked(submission, stage.stage);
}

/// What is said of the whole: notes of the hand-in, own marks, and what it was graded with.
std::string words_of_all(const Run& run, const SubmissionResult& submission) {
  std::string out;
  if (!is_settled(summarize(submission))) out += say(text::report_not_settled) + "\n";
  for (const std::string& note : submission.notes) out += note + "\n";
  for (const Override& own : submission.overrides) out += override_words(own) + "\n";
  out += say(text::report_toolkit, {run.toolkit}) + " · " +
         say(text::report_seed, {std::to_string(submission.seed)}) + " · " +
         box_words(submission.box);
  return clean(out);
}

}  // namespace

std::string gradescope_json(const Run& run, const SubmissionResult& submission,
                            const std::vector<std::string>& pictures) {
  Json tests = Json::array();
  for (std::size_t i = 0; i < submission.stages.size(); ++i) {
    const StageResult& stage = submission.stages[i];
    const std::string place = std::to_string(i + 1);
    Json test;
    if (has_points(submission, stage)) {
      test["score"] = number(points_of(submission, stage));
      test["max_score"] = number(stage.most);
      test["status"] = stage.status == Status::passed ? "passed" : "failed";
    }
    test["name"] = one_line(stage_title(stage.stage));
    test["name_format"] = "text";
    test["number"] = place;
    test["output"] = stage_text(stage, shown(run.feedback));
    test["output_format"] = "text";
    test["tags"] = Json::array({one_line(stage.stage)});
    test["visibility"] = "visible";  // a hidden one would hide the total from the student
    tests.push_back(test);
    if (i < pictures.size() && !pictures[i].empty()) {
      tests.push_back(
          {{"name", one_line(stage_title(stage.stage) + ": " + say(text::report_pictures))},
           {"name_format", "text"},
           {"number", place + ".1"},
           {"output", pictures[i]},
           {"output_format", "ansi"},
           {"visibility", "visible"}});
    }
  }
  const Json json = {{"score", number(submission.points())},
                     {"output", words_of_all(run, submission)},
                     {"output_format", "text"},
                     {"test_output_format", "text"},
                     {"test_name_format", "text"},
                     {"visibility", "visible"},
                     {"tests", tests}};
  return dump(json, 2) + "\n";
}

Objections gradescope_preflight(const SubmissionResult& submission) {
  Objections out;
  const Summary summary = summarize(submission);
  if (!is_settled(summary)) out.push_back({submission.id, say(text::report_no_mark), false});
  if (submission.points() < 0) {
    out.push_back(
        {submission.id, say(text::report_below_zero, {points_text(submission.points())}), false});
  }
  return out;
}

std::string actions_json(const Run& run, const SubmissionResult& submission) {
  Json tests = Json::array();
  int given = 0;
  const auto add = [&](const std::string& title, std::string_view status, int points,
                       const std::string& message) {
    given += points;
    tests.push_back({{"name", workflow_text(one_line(title))},
                     {"status", status},
                     {"score", number(points)},
                     {"message", workflow_text(message)},
                     {"test_code", ""},
                     {"filename", ""},
                     {"line_no", 0},
                     {"duration", 0}});
  };
  bool failed = false;
  for (const StageResult& stage : submission.stages) {
    const bool judged = has_points(submission, stage);
    failed = failed || stage.status == Status::failed;
    add(stage_title(stage.stage),
        !judged                          ? "error"
        : stage.status == Status::passed ? "pass"
                                         : "fail",
        judged ? points_of(submission, stage) : 0, stage_text(stage, shown(run.feedback)));
  }
  // The reporter adds up the entries: a mark for the whole has to be one of them.
  if (const int more = submission.points() - given; more != 0 && is_marked(submission, "")) {
    for (const Override& own : submission.overrides) {
      if (own.stage.empty()) {
        add(say(text::report_own_marks), "pass", more, override_words(own));
        break;
      }
    }
  }
  const bool settled = is_settled(summarize(submission));
  const Json json = {{"version", 1},
                     {"status", !settled ? "error"
                                : failed ? "fail"
                                         : "pass"},
                     {"max_score", number(submission.most())},
                     {"tests", tests}};
  return dump(json, -1);
}

std::string actions_output(const Run& run, const SubmissionResult& submission) {
  return "result=" + base64(actions_json(run, submission)) + "\n";
}

}  // namespace fos::grading
