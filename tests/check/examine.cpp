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

/// What came for the questions' scenes.
class Answers {
 public:
  Answers(const Questions& questions, const std::vector<Asked>& all)
      : questions_(questions), all_(all) {}

  const Asked& of(const Judge& judge) const { return all_[questions_.place(judge)]; }
  const Asked& of(const PixelCase& pixel) const { return all_[questions_.place(pixel)]; }

 private:
  const Questions& questions_;
  const std::vector<Asked>& all_;
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
    if (asked.is_whole() && is_right(*asked.frame, pixel)) continue;
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
Finding find_whole_frames(const Questions& questions, const Answers& answers, Findings& findings) {
  const Stage& stage = questions.stage();
  const int scenes = static_cast<int>(stage.scenes.size());
  Finding finding{say(text::check_every_pixel), Outcome::passed, 0, scenes, "", std::nullopt};
  bool all_asked = true;
  bool wrong_is_shown = false;
  for (std::size_t i = 0; i < stage.scenes.size(); ++i) {
    const Judge& judge = *questions.judges()[i];
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
      findings.shown = {name, questions.judges()[i], asked.frame, verdict};
      wrong_is_shown = !verdict.passes();
    }
  }
  finding.outcome = outcome(finding, all_asked);
  return finding;
}

}  // namespace

Questions::Questions(const Stage& stage)
    : stage_(&stage), test_(&stage_test(stage.id)), lecture_(read_scene_text(FOS_LECTURE_SCENE)) {
  judges_.resize(stage.scenes.size());
  in_parallel(judges_.size(), [&] {
    return [&](std::size_t i) {
      const std::string file = std::string(stage.scenes[i]) + ".ref";
      judges_[i] = std::make_shared<const Judge>(
          reference::read_reference(std::filesystem::path(FOS_REFERENCE_DATA) / file), stage.terms);
    };
  });
  for (const auto& judge : judges_) add(judge->scene());
  for (const Check& check : test_->checks) {
    for (const PixelCase& pixel : check.pixels) add(scene(pixel));
  }
}

SceneText Questions::scene(const PixelCase& pixel) const {
  return pixel.scene.empty() ? lecture_ : parse_scene_text(pixel.scene, "scene");
}

void Questions::add(const SceneText& scene) {
  if (places_.emplace(scene.source, scenes_.size()).second) scenes_.push_back(scene);
}

Findings examine(const Questions& questions, const std::vector<Asked>& answers) {
  const Answers came(questions, answers);
  Findings findings;
  findings.stage = &questions.stage();
  for (const Check& check : questions.test().checks) findings.list.push_back(find(check, came));
  findings.list.push_back(find_whole_frames(questions, came, findings));
  for (const Finding& finding : findings.list) {
    findings.passed += finding.passed;
    findings.things += finding.things;
  }
  for (const Asked& asked : answers) {
    if (asked.asked && asked.answer.ending != Ending::complete && findings.printed.empty()) {
      findings.printed = asked.printed;
    }
  }
  return findings;
}

Findings examine(const Questions& questions, const std::filesystem::path& program,
                 const Limits& limits, const std::stop_token& stop) {
  const std::vector<Asked> answers = ask_all(program, limits, questions.scenes(), stop);
  for (const Asked& asked : answers) {
    if (asked.answer.ending == Ending::did_not_start) {
      throw std::runtime_error(describe(asked.answer, program.string()));
    }
  }
  return examine(questions, answers);
}

Limits patient_limits() { return {std::chrono::seconds(60), 5, true, true}; }

}  // namespace fos
