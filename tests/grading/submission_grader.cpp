#include "submission_grader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "advice.hpp"
#include "asking.hpp"
#include "check_report.hpp"
#include "check_screen.hpp"
#include "comparison.hpp"
#include "fos/text.hpp"

namespace fos::grading {
namespace {

/// A stage of which nothing can be asked.
StageResult without_program(const Stage& stage, Status status, Cause cause) {
  StageResult result;
  result.stage = stage.id;
  result.most = 100 * stage.points;
  result.status = status;
  result.cause = cause;
  return result;
}

std::string at_most(std::string text) {
  if (text.size() > most_text) text.resize(most_text);
  return text;
}

/// The box ends what takes too long; this is for what escapes all else.
const Limits box_decides{std::chrono::minutes(10), 0, true, true};

}  // namespace

SubmissionGrader::SubmissionGrader(const Course& course, unsigned slot,
                                   std::filesystem::path scratch)
    : course_(course),
      slot_(slot),
      box_(course.box, slot, scratch / "box"),
      scratch_(std::move(scratch)),
      maker_(course.picture_program) {
  std::filesystem::create_directories(scratch_);
}

SubmissionResult SubmissionGrader::grade(const HandIn& hand_in,
                                         const std::filesystem::path& pictures,
                                         const std::function<void()>& on_wait) {
  on_wait_ = on_wait;
  charged_.clear();
  SubmissionResult result;
  result.id = hand_in.whose.id;
  result.name = hand_in.whose.name;
  result.username = hand_in.whose.username;
  result.email = hand_in.whose.email;
  result.source = hand_in.whose.source;
  result.box = name(box_.level());
  result.seed = course_.seed;
  result.notes = hand_in.notes;
  result.status = Status::passed;
  for (const StageQuestions& questions : course_.stages) {
    const auto file =
        std::find_if(hand_in.files.begin(), hand_in.files.end(),
                     [&](const StageFile& each) { return each.stage == questions.stage().id; });
    if (file == hand_in.files.end()) continue;
    result.stages.push_back(grade_stage(questions, *file, pictures));
    const Status status = result.stages.back().status;
    if (status == Status::not_judged) result.status = Status::not_judged;
    if (status == Status::failed && result.status == Status::passed) result.status = Status::failed;
  }
  return result;
}

StageResult SubmissionGrader::grade_stage(const StageQuestions& questions, const StageFile& file,
                                          const std::filesystem::path& pictures) {
  const Stage& stage = questions.stage();
  if (file.why != Why::none) {
    StageResult result = without_program(stage, Status::failed, Cause::no_file);
    result.program = file.words;
    return result;
  }
  std::string trouble;
  for (int attempt = 0; attempt < 2; ++attempt) {
    try {
      return ask_stage(questions, file, pictures);
    } catch (const InfrastructureError& error) {
      trouble = error.what();
    }
  }
  StageResult result = without_program(stage, Status::not_judged, Cause::infrastructure);
  result.program = at_most(trouble);
  return result;
}

std::filesystem::path SubmissionGrader::program_of(const Stage& stage) const {
  return course_.workshop->programs() / fmt::format("{}-{}", slot_, stage.id);
}

CompileResult SubmissionGrader::compiled(const StageQuestions& questions, const StageFile& file,
                                         bool sanitized) {
  const Stage& stage = questions.stage();
  CompileJob job;
  job.source = scratch_ / (std::string(stage.id) + ".cpp");
  job.name = "labs/" + stage_file(stage);
  job.lecture = stage.lecture;
  job.sanitized = sanitized;
  job.program = program_of(stage);
  std::ofstream(job.source, std::ios::binary) << file.content;
  return compile(*course_.workshop, box_, slot_, job, on_wait_);
}

StageResult SubmissionGrader::ask_stage(const StageQuestions& questions, const StageFile& file,
                                        const std::filesystem::path& pictures) {
  const CompileResult made = compiled(questions, file, false);
  if (made.ending == CompileEnding::infrastructure) throw InfrastructureError(made.run.output);
  if (made.ending != CompileEnding::compiled) {
    StageResult result = without_program(questions.stage(), Status::failed, Cause::not_compiled);
    result.compiler = at_most(made.output);
    return result;
  }
  StageProgram program(stage_command(box_, program_of(questions.stage()), BoxLimits{}),
                       box_decides);
  const std::vector<Asked> answers = ask_in_turn(program, questions.scenes(), on_wait_);
  const Findings findings = examine_checks(questions, answers);
  StageResult result = score(questions, findings, answers, course_.shares);
  result.compiler = at_most(made.output);
  if (result.status == Status::failed) {
    // What never answers would only be waited for again.
    if (result.cause != Cause::out_of_time) advise_on(result, program, questions, answers);
    if (result.cause == Cause::crashed)
      result.sanitizer = where_it_crashed(questions, file, answers);
    make_pictures(result, findings, pictures);
  }
  program.end();
  result.cpu_seconds = program.cpu_seconds();
  return result;
}

void SubmissionGrader::advise_on(StageResult& result, StageProgram& program,
                                 const StageQuestions& questions,
                                 const std::vector<Asked>& answers) {
  const Advice advice = advise(questions.stage(), [&](const std::vector<SceneText>& scenes) {
    return frames_of(ask_in_turn(program, scenes, on_wait_));
  });
  result.mistake = advice.mistake;
  const std::vector<std::string> asked = fos::questions(advice.diagnosis);
  result.advice = asked.empty() ? advice.words : fmt::format("{}", fmt::join(asked, "\n"));
  const std::vector<MistakeMade>& certain = advice.diagnosis.certain;
  if (certain.empty() || !advice.diagnosis.one_of.empty()) return;
  const bool all_charged =
      std::all_of(certain.begin(), certain.end(),
                  [&](const MistakeMade& made) { return charged_.contains(made.mistake); });
  if (all_charged) count_carried(result, questions, answers, advice.diagnosis, course_.shares);
  for (const MistakeMade& made : certain) charged_.insert(made.mistake);
}

std::string SubmissionGrader::where_it_crashed(const StageQuestions& questions,
                                               const StageFile& file,
                                               const std::vector<Asked>& answers) {
  const auto crash = std::find_if(answers.begin(), answers.end(), [](const Asked& asked) {
    return asked.asked && asked.answer.ending == Ending::crashed;
  });
  if (crash == answers.end()) return "";
  if (compiled(questions, file, true).ending != CompileEnding::compiled) return "";
  StageProgram program(stage_command(box_, program_of(questions.stage()), BoxLimits{}, true),
                       box_decides);
  const std::vector<SceneText> scene{
      questions.scenes()[static_cast<std::size_t>(crash - answers.begin())]};
  return at_most(ask_in_turn(program, scene, on_wait_).front().printed);
}

void SubmissionGrader::make_pictures(StageResult& result, const Findings& findings,
                                     const std::filesystem::path& folder) {
  if (!findings.shown || findings.shown->verdict.passes()) return;
  const std::vector<Panel> panels = panels_of(findings, difference_of(findings));
  constexpr std::array kinds{"yours", "expected", "difference"};
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < panels.size() && i < kinds.size(); ++i) {
    const std::string name = result.stage + "-" + kinds[i] + ".png";
    if (maker_.make({folder / name, {panels[i]}, check_panel_size}))
      result.pictures.push_back(name);
  }
}

}  // namespace fos::grading
