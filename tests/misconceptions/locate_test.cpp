// Where nothing is named, the first link that is wrong is found, and no later one.
#include "locate.hpp"

#include <functional>

#include "catch2.hpp"
#include "diagnosis.hpp"
#include "scene_at.hpp"

using namespace fos;

namespace {

const Stage& stage_named(std::string_view id) {
  for (const Stage& stage : stages) {
    if (stage.id == id) return stage;
  }
  throw std::runtime_error("no such stage");
}

/// What a mistake of the tracer shows, its pixels changed afterwards.
using Change = std::function<void(Frame&)>;
Location located(
    std::string_view stage_id, const MistakeSet& mistakes, const Change& change = [](Frame&) {}) {
  const Stage& stage = stage_named(stage_id);
  const auto frame_of = [&](const SceneText& scene) {
    Frame frame = mistaken_frame(SceneAt<double>(scene), stage.terms, mistakes);
    change(frame);
    return frame;
  };
  std::vector<Frame> frames;
  for (const SceneText& scene : diagnostic_scenes(stage)) frames.push_back(frame_of(scene));
  std::vector<Frame> term_frames;
  for (const TermScene& term : term_scenes(stage)) term_frames.push_back(frame_of(term.scene));
  return locate(stage, frames, term_frames);
}

std::string all_words(const Location& location) {
  std::string words;
  for (const std::string& each : location.words) words += each + "\n";
  return words;
}

}  // namespace

TEST_CASE("nothing is wrong with what is right") {
  for (const Stage& stage : stages) {
    INFO(stage.id);
    const Location location = located(stage.id, {});
    INFO(all_words(location));
    CHECK(location.link == Link::none);
    CHECK(location.words.empty());
  }
}

TEST_CASE("each link") {
  const auto link = [](std::string_view stage, const MistakeSet& mistakes) {
    return located(stage, mistakes).link;
  };
  CHECK(link("flat_color", {Mistake::black_background}) == Link::background);
  CHECK(link("flat_color", {Mistake::last_sphere}) == Link::spheres);
  CHECK(link("flat_color", {Mistake::color_over_255}) == Link::colors);
  CHECK(link("ambient", {Mistake::ambient_forgotten}) == Link::ambient);
  CHECK(link("ambient", {Mistake::light_as_grey}) == Link::colors);
  CHECK(link("combined", {Mistake::ambient_twice}) == Link::ambient);
  CHECK(link("combined", {Mistake::N_inward}) == Link::behind);
  CHECK(link("point", {Mistake::absolute_cosine}) == Link::behind);
  CHECK(link("point", {Mistake::falloff}) == Link::strength);
  CHECK(link("directional", {Mistake::cosine_squared}) == Link::strength);
  CHECK(link("point", {Mistake::first_light_only}) == Link::sum);
  CHECK(link("point", {Mistake::brightest_light}) == Link::sum);
}

TEST_CASE("of the lights, the kind that is wrong") {
  CHECK_THAT(all_words(located("combined", {Mistake::direction_negated})),
             ContainsSubstring("directional lights") && !ContainsSubstring("point lights"));
  CHECK_THAT(all_words(located("combined", {Mistake::L_reversed})),
             ContainsSubstring("point lights") && !ContainsSubstring("directional lights"));
}

TEST_CASE("how the strength goes wrong") {
  const auto words = [](std::string_view stage, const MistakeSet& mistakes) {
    return all_words(located(stage, mistakes));
  };
  CHECK_THAT(words("point", {Mistake::L_not_normalised}), ContainsSubstring("|L|^1"));
  CHECK_THAT(words("point", {Mistake::falloff}), ContainsSubstring("|L|^-2"));
  CHECK_THAT(words("point", {Mistake::divided_by_L_squared}), ContainsSubstring("|L|^-1"));
  CHECK_THAT(words("point", {Mistake::intensity_forgotten}), ContainsSubstring("each light"));
  CHECK_THAT(words("point", {Mistake::N_not_normalised}), ContainsSubstring("each sphere"));
  CHECK_THAT(words("point", {Mistake::cosine_squared}), ContainsSubstring("the angle"));
  CHECK_THAT(words("directional", {Mistake::angle_for_cosine}), ContainsSubstring("the angle"));
  CHECK_THAT(words("directional", {Mistake::L_not_normalised}), ContainsSubstring("each light"));
}

TEST_CASE("what is not finite or not written is not looked at") {
  const auto spoiled = [](long double value) {
    return located("point", {Mistake::falloff}, [=](Frame& frame) { frame.channels[5] = value; });
  };
  CHECK(spoiled(std::nanl("")).link == Link::none);
  CHECK(located("point", {Mistake::falloff}, [](Frame& frame) { frame.unwritten[7] = 1; }).link ==
        Link::none);
}
