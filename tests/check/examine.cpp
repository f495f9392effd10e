#include "examine.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "asked.hpp"
#include "fos/text.hpp"
#include "parallel.hpp"
#include "report.hpp"

namespace fos {
namespace {

/// The scenes of a stage's test, each once, and what came for them.
class Answers {
 public:
  Answers(const Stage& stage, const StageTest& test)
      : lecture_(read_scene_text(FOS_LECTURE_SCENE)) {
    judges_.resize(stage.scenes.size());
    in_parallel(judges_.size(), [&] {
      return [&](std::size_t i) {
        const std::string file = std::string(stage.scenes[i]) + ".ref";
        judges_[i] = std::make_shared<const Judge>(
            reference::read_reference(std::filesystem::path(FOS_REFERENCE_DATA) / file),
            stage.terms);
      };
    });
    // The large ones first, so that no processor is left waiting for one at the end.
    for (const auto& judge : judges_) add(judge->scene());
    for (const Check& check : test.checks) {
      for (const PixelCase& pixel : check.pixels) add(scene(pixel));
    }
  }

  void ask(const std::filesystem::path& program, const Limits& limits,
           const std::stop_token& stop) {
    answers_ = ask_all(program, limits, scenes_, stop);
    for (const Asked& asked : answers_) {
      if (asked.answer.ending == Ending::did_not_start) {
        throw std::runtime_error(describe(asked.answer, program.string()));
      }
    }
  }

  const std::vector<std::shared_ptr<const Judge>>& judges() const { return judges_; }
  const Asked& of(const Judge& judge) const { return at(judge.scene()); }
  const Asked& of(const PixelCase& pixel) const { return at(scene(pixel)); }
  const std::vector<Asked>& all() const { return answers_; }

 private:
  SceneText scene(const PixelCase& pixel) const {
    return pixel.scene.empty() ? lecture_ : parse_scene_text(pixel.scene, "scene");
  }
  void add(const SceneText& scene) {
    if (places_.emplace(scene.source, scenes_.size()).second) scenes_.push_back(scene);
  }
  const Asked& at(const SceneText& scene) const { return answers_[places_.at(scene.source)]; }

  SceneText lecture_;
  std::vector<std::shared_ptr<const Judge>> judges_;  // one a scene of the stage
  std::vector<SceneText> scenes_;
  std::map<std::string, std::size_t> places_;  // by their text
  std::vector<Asked> answers_;
};

Outcome outcome(const Finding& finding, bool all_asked) {
  if (finding.passed == finding.things) return Outcome::passed;
  return all_asked || !finding.why.empty() ? Outcome::failed : Outcome::not_judged;
}

bool is_right(const Frame& frame, const PixelCase& pixel) {
  const auto came = frame.pixel(pixel.pixel.column, pixel.pixel.row);
  if (frame.is_unwritten(pixel.pixel.column, pixel.pixel.row) || !is_finite(came)) return false;
  for (std::size_t i = 0; i < came.size(); ++i) {
    if (std::abs(std::min(came[i], 255.0L) - std::min(pixel.expected[i], 255.0)) > 0.01)
      return false;
  }
  return true;
}

Finding find(const Check& check, const Answers& answers) {
  Finding finding{say(check.words), Outcome::passed, 1, 1, "", std::nullopt};
  bool all_asked = true;
  for (const PixelCase& pixel : check.pixels) {
    const Asked& asked = answers.of(pixel);
    if (asked.asked && asked.answer.ending == Ending::complete && is_right(*asked.frame, pixel)) {
      continue;
    }
    finding.passed = 0;
    all_asked = all_asked && asked.asked;
    if (!asked.asked || !finding.why.empty()) continue;
    if (asked.answer.ending == Ending::complete) {
      finding.why = describe(pixel, *asked.frame);
      finding.spot = {pixel.scene, pixel.pixel};
    } else {
      finding.why = describe(asked.answer, say(pixel.scene.empty() ? text::check_the_lecture
                                                                   : text::check_this_scene));
    }
  }
  finding.outcome = outcome(finding, all_asked);
  return finding;
}

/// Every pixel of every scene of the stage, and which of them to show.
Finding find_whole_frames(const Stage& stage, const Answers& answers, Findings& findings) {
  const int scenes = static_cast<int>(stage.scenes.size());
  Finding finding{say(text::check_every_pixel), Outcome::passed, 0, scenes, "", std::nullopt};
  bool all_asked = true;
  bool wrong_is_shown = false;
  for (std::size_t i = 0; i < stage.scenes.size(); ++i) {
    const Judge& judge = *answers.judges()[i];
    const Asked& asked = answers.of(judge);
    all_asked = all_asked && asked.asked;
    if (!asked.asked) continue;
    const std::string name(stage.scenes[i]);
    if (asked.answer.ending != Ending::complete) {
      if (finding.why.empty()) finding.why = describe(asked.answer, name);
      continue;
    }
    const Verdict verdict = judge.judge(*asked.frame);
    const std::string words = describe(judge, *asked.frame, verdict, name);
    if (verdict.passes()) {
      ++finding.passed;
      findings.note += words;
    } else if (finding.why.empty()) {
      finding.why = words;
      finding.spot = {name == "lecture" ? "" : judge.scene().source, verdict.first_wrong()};
    }
    if (!findings.shown || (!verdict.passes() && !wrong_is_shown)) {
      findings.shown = {name, answers.judges()[i], asked.frame, verdict};
      wrong_is_shown = !verdict.passes();
    }
  }
  finding.outcome = outcome(finding, all_asked);
  return finding;
}

}  // namespace

Findings examine(const Stage& stage, const std::filesystem::path& program, const Limits& limits,
                 const std::stop_token& stop) {
  const StageTest& test = stage_test(stage.id);
  Answers answers(stage, test);
  answers.ask(program, limits, stop);
  Findings findings;
  findings.stage = &stage;
  for (const Check& check : test.checks) findings.list.push_back(find(check, answers));
  findings.list.push_back(find_whole_frames(stage, answers, findings));
  for (const Finding& finding : findings.list) {
    findings.passed += finding.passed;
    findings.things += finding.things;
  }
  for (const Asked& asked : answers.all()) {
    if (asked.asked && asked.answer.ending != Ending::complete && findings.printed.empty()) {
      findings.printed = asked.printed;
    }
  }
  return findings;
}

Limits patient_limits() { return {std::chrono::seconds(60), 5, true, true}; }

}  // namespace fos
