// From answers to points, with the tracer that makes mistakes in the place of students' programs.
#include <algorithm>
#include <cmath>
#include <map>

#include "catch2.hpp"
#include "scene_at.hpp"
#include "stage_score.hpp"

using namespace fos;
using namespace fos::grading;

namespace {

constexpr std::uint64_t seed = 11;
constexpr Shares shares{60, 25, 15};

const Stage& stage_named(std::string_view id) {
  return *std::find_if(std::begin(stages), std::end(stages),
                       [&](const Stage& each) { return each.id == id; });
}

const StageQuestions& questions_of(std::string_view id) {
  static const DrawnScenes drawn(seed);
  static std::map<std::string, StageQuestions, std::less<>> all;
  const auto found = all.find(id);
  if (found != all.end()) return found->second;
  return all.emplace(std::string(id), StageQuestions(stage_named(id), drawn)).first->second;
}

Asked whole(Frame frame) {
  Asked asked;
  asked.asked = true;
  asked.frame = std::make_shared<const Frame>(std::move(frame));
  return asked;
}

/// What a program with these mistakes answers.
std::vector<Asked> answers(const StageQuestions& questions, const MistakeSet& mistakes) {
  std::vector<Asked> all;
  for (const SceneText& scene : questions.scenes()) {
    all.push_back(whole(mistaken_frame(SceneAt<double>(scene), questions.stage().terms, mistakes)));
  }
  return all;
}

grading::StageResult scored(const StageQuestions& questions, const std::vector<Asked>& all) {
  return score(questions, examine_checks(questions, all), all, shares);
}

int passed(const grading::StageResult& result, Part part) {
  int sum = 0;
  for (const CheckResult& check : result.checks) sum += check.part == part ? check.passed : 0;
  return sum;
}

}  // namespace

TEST_CASE("a right program has every point, in every stage") {
  for (const Stage& stage : stages) {
    INFO(stage.id);
    const StageQuestions& questions = questions_of(stage.id);
    const auto result = scored(questions, answers(questions, {}));
    CHECK(result.points == 100 * stage.points);
    CHECK(result.status == Status::passed);
    CHECK(passed(result, Part::scenes) == DrawnScenes::count);
    CHECK(passed(result, Part::relations) == static_cast<int>(relations.size()));
  }
}

TEST_CASE("a mistake costs in every part, and no line gives more than it is worth") {
  const StageQuestions& questions = questions_of("point");
  for (const Mistake mistake : {Mistake::P_without_O, Mistake::N_inward, Mistake::cosine_squared}) {
    const auto result = scored(questions, answers(questions, {mistake}));
    CHECK(result.status == Status::failed);
    CHECK(result.points < result.most * 2 / 3);
    CHECK(passed(result, Part::scenes) < DrawnScenes::count);
    CHECK(passed(result, Part::relations) < static_cast<int>(relations.size()));
    int sum = 0;
    for (const CheckResult& check : result.checks) {
      CHECK(check.points <= check.most);
      CHECK(check.points == (check.passed == check.things ? check.most : check.points));
      sum += check.points;
    }
    CHECK(sum == result.points);
  }
}

TEST_CASE("nothing that came gives no points") {
  const StageQuestions& questions = questions_of("point");
  const auto never = scored(questions, std::vector<Asked>(questions.scenes().size()));
  CHECK(never.points == 0);
  CHECK(never.cause == Cause::out_of_time);
  std::vector<Asked> crashed = answers(questions, {});
  for (Asked& asked : crashed) asked.answer.ending = Ending::crashed;
  CHECK(scored(questions, crashed).points == 0);
  CHECK(scored(questions, crashed).cause == Cause::crashed);
}

TEST_CASE("what is unwritten, and what is no number, is told as that") {
  const StageQuestions& questions = questions_of("ambient");
  std::vector<Asked> unwritten;
  std::vector<Asked> not_finite;
  for (const Asked& asked : answers(questions, {})) {
    Frame frame = *asked.frame;
    std::fill(frame.unwritten.begin(), frame.unwritten.end(), 1);
    unwritten.push_back(whole(frame));
    frame = *asked.frame;
    std::fill(frame.channels.begin(), frame.channels.end(), std::nanl(""));
    not_finite.push_back(whole(frame));
  }
  for (const auto& [all, cause] :
       {std::pair(&unwritten, Cause::unwritten), std::pair(&not_finite, Cause::not_finite)}) {
    const auto result = scored(questions, *all);
    CHECK(result.points == 0);
    for (const CheckResult& check : result.checks) CHECK(check.cause == cause);
  }
}

TEST_CASE("a relation holds of right frames alone") {
  const StageQuestions& questions = questions_of("combined");
  const std::vector<Asked> right = answers(questions, {});
  for (const Relation relation : relations) {
    const std::size_t base = StageQuestions::base_of(relation);
    const Judge& judge = *questions.drawn()[base];
    const Frame& from = *right[questions.first_drawn() + base].frame;
    const Frame& to = *right[questions.place(relation)].frame;
    CHECK(holds(relation, true, judge, from, to));
    // The frame of another relation, or one with a pixel that is off, is not what is foretold.
    const auto other = static_cast<Relation>((static_cast<std::size_t>(relation) + 1) % 3);
    CHECK_FALSE(holds(relation, true, judge, from, *right[questions.place(other)].frame));
    Frame off = to;
    off.channels[off.channels.size() / 2 + 144] += 1;  // in the middle of a row
    CHECK_FALSE(holds(relation, true, judge, from, off));
  }
}

TEST_CASE("a picture that was written down beforehand has no points for scenes it does not know") {
  const StageQuestions& questions = questions_of("point");
  std::vector<Asked> all = answers(questions, {});
  for (std::size_t i = questions.first_drawn(); i < all.size(); ++i) {
    all[i] = whole(mistaken_frame(SceneAt<double>(questions.scenes()[i]), ambient_term, {}));
  }
  const auto result = scored(questions, all);
  CHECK(passed(result, Part::scenes) == 0);
  CHECK(passed(result, Part::relations) == 0);
  CHECK(result.points == result.most * shares.checks / 100);
}

TEST_CASE("a mistake that is carried over is taken for right, and no other") {
  const StageQuestions& questions = questions_of("combined");
  const std::vector<Asked> all = answers(questions, {Mistake::P_without_O});
  Diagnosis made;
  made.certain = {{Mistake::P_without_O}};
  auto result = scored(questions, all);
  count_carried(result, questions, all, made, shares);
  CHECK(result.carried);
  CHECK(result.points == result.most);
  Diagnosis other;
  other.certain = {{Mistake::N_inward}};
  result = scored(questions, all);
  const int before = result.points;
  count_carried(result, questions, all, other, shares);
  CHECK(result.points == before);
  CHECK_FALSE(result.carried);
}

TEST_CASE("scenes are drawn alike from a seed, and otherwise from another") {
  CHECK(draw_scene(5, 1).text() == draw_scene(5, 1).text());
  CHECK(draw_scene(5, 1).text() != draw_scene(5, 2).text());
  CHECK(draw_scene(5, 1).text() != draw_scene(6, 1).text());
}

TEST_CASE("drawn scenes are as ordinary as they say") {
  for (std::uint64_t number = 0; number < 200; ++number) {
    const DrawnScene scene = draw_scene(number, static_cast<int>(number % 4));
    CHECK_NOTHROW(parse_scene_text(scene.text(), "drawn"));
    CHECK(scene.ambient % 2 == 0);
    CHECK(scene.lights.size() >= 2);
    for (const DrawnLight& light : scene.lights) CHECK(light.intensity % 2 == 0);
    for (const DrawnSphere& sphere : scene.spheres) {
      // The surface is further than 1.3 from the camera, or below what it sees at t = 1.
      long double squared = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto far = static_cast<long double>(sphere.center[i] - scene.camera[i]);
        squared += far * far;
      }
      CHECK(std::abs(std::sqrt(squared) - static_cast<long double>(sphere.radius)) > 1050);
    }
  }
}
