// Every mistake is named, alone and with each other, and nothing that is not made is.
#include "diagnosis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>

#include "catch2.hpp"
#include "stage_frames.hpp"

using namespace fos;

namespace {

/// Whether these mistakes are what the diagnosis says, or one of the things that it may be.
bool names(const Diagnosis& diagnosis, const MistakeSet& mistakes) {
  const auto complete = [&](std::vector<MistakeMade> findings) {
    findings.insert(findings.end(), diagnosis.certain.begin(), diagnosis.certain.end());
    MistakeSet named;
    for (const MistakeMade& finding : findings) named.add(finding.mistake);
    return named == mistakes;
  };
  if (diagnosis.one_of.empty()) return complete({});
  return std::any_of(diagnosis.one_of.begin(), diagnosis.one_of.end(), complete);
}

std::string ids(const Diagnosis& diagnosis) {
  std::string all;
  for (const MistakeMade& finding : diagnosis.certain) {
    all.append(misconception(finding.mistake).id).append(" ");
  }
  for (const auto& each : diagnosis.one_of) {
    all.append("| ");
    for (const MistakeMade& finding : each)
      all.append(misconception(finding.mistake).id).append(" ");
  }
  return all.empty() ? "nothing" : all;
}

std::size_t mistakes_in(const Diagnosis& diagnosis) {
  return diagnosis.certain.size() + (diagnosis.one_of.empty() ? 0 : diagnosis.one_of[0].size());
}

/// Whether two mistakes can be made together in a stage.
bool go_together(const Misconception& a, const Misconception& b, const Stage& stage) {
  return a.mistake < b.mistake && a.slot != b.slot &&
         (a.stages & b.stages & stage_bit(stage.id)) != 0;
}

}  // namespace

TEST_CASE("every mistake is named, at double and at float") {
  int all = 0;
  int named = 0;
  for (const Stage& stage : stages) {
    for (const Misconception& each : misconceptions()) {
      if ((each.stages & stage_bit(stage.id)) == 0) continue;
      const MistakeSet made{each.mistake};
      const Diagnosis at_double = diagnose(stage, mistaken_frames<double>(stage, made));
      INFO(stage.id << " " << each.id << ": " << ids(at_double));
      CHECK(names(at_double, made));
      const Diagnosis at_float = diagnose(stage, mistaken_frames<float>(stage, made));
      INFO("at float: " << ids(at_float));
      CHECK(names(at_float, made));
      ++all;
      named += names(at_double, made) && names(at_float, made) ? 1 : 0;
    }
  }
  const std::string share =
      fmt::format("mistakes: {} in the catalogue; made at {} places of the stages, {} named\n",
                  misconceptions().size(), all, named);
  fmt::print("{}", share);
  std::ofstream(FOS_SHARE) << share;
}

TEST_CASE("of two mistakes made together none is named that does not show") {
  for (const Stage& stage : stages) {
    int all = 0;
    int named = 0;
    int unnamed = 0;
    for (const Misconception& a : misconceptions()) {
      for (const Misconception& b : misconceptions()) {
        if (!go_together(a, b, stage)) continue;
        const MistakeSet made{a.mistake, b.mistake};
        const Diagnosis diagnosis = diagnose(stage, mistaken_frames<float>(stage, made));
        ++all;
        named += names(diagnosis, made) ? 1 : 0;
        unnamed += diagnosis.named() ? 0 : 1;
        // What is not named as the two is named as something simpler that gives the same picture.
        INFO(stage.id << " " << a.id << " + " << b.id << ": " << ids(diagnosis));
        CHECK((names(diagnosis, made) || mistakes_in(diagnosis) <= 1));
      }
    }
    fmt::print(
        "{}: {} pairs of mistakes, {} named as such, {} as one with the same picture, {} not "
        "named\n",
        stage.id, all, named, all - named - unnamed, unnamed);
    CHECK(unnamed <= all / 50);
  }
}

TEST_CASE("where no sphere is seen, no other mistake is named") {
  const Stage& stage = stages[0];
  REQUIRE(stage.id == "flat_color");
  for (const Misconception& each : misconceptions()) {
    if ((each.stages & in_flat_color) == 0 || each.mistake == Mistake::no_sphere) continue;
    const MistakeSet made{Mistake::no_sphere, each.mistake};
    const std::string found = ids(diagnose(stage, mistaken_frames<double>(stage, made)));
    INFO(each.id);
    CHECK(found == (each.slot == Slot::background ? "nothing" : "no_sphere "));
  }
}

TEST_CASE("right frames, and frames that are not there, have no name") {
  for (const Stage& stage : stages) {
    INFO(stage.id);
    CHECK_FALSE(diagnose(stage, mistaken_frames<double>(stage, {})).named());
    CHECK_FALSE(diagnose(stage, mistaken_frames<float>(stage, {})).named());
    CHECK_FALSE(diagnose(stage, {}).named());
    CHECK_FALSE(diagnose(stage, std::vector<Frame>(12)).named());
  }
}

TEST_CASE("a frame that is not finished or not finite has no name") {
  const Stage& stage = stages[2];
  const std::vector<Frame> wrong = mistaken_frames<double>(stage, {Mistake::L_reversed});
  REQUIRE(diagnose(stage, wrong).named());
  std::vector<Frame> frames = wrong;
  frames[0].unwritten[100] = 1;
  CHECK_FALSE(diagnose(stage, frames).named());
  frames = wrong;
  frames[1].channels[300] = std::numeric_limits<long double>::quiet_NaN();
  CHECK_FALSE(diagnose(stage, frames).named());
  frames = wrong;
  frames[2].channels[std::size_t{3} * 400] += 2;  // one channel of one pixel
  CHECK_FALSE(diagnose(stage, frames).named());
}

TEST_CASE("a diagnosis in words says the name, the question and the slide") {
  const Stage& stage = stages[2];
  const auto lines =
      describe(diagnose(stage, mistaken_frames<double>(stage, {Mistake::L_not_normalised})));
  REQUIRE(lines.size() == 3);
  CHECK(lines[0] == say(text::mistake_L_not_normalised));
  CHECK_THAT(lines[1], ContainsSubstring(say(text::mistake_L_not_normalised_question)));
  CHECK_THAT(lines[2], ContainsSubstring("Μοντελοποιώντας την διάχυτη ανάκλαση"));
  CHECK(describe({}).empty());
  // Alike, and so named together.
  const auto either =
      describe(diagnose(stage, mistaken_frames<double>(stage, {Mistake::L_reversed})));
  CHECK(either.size() == 8);
}
