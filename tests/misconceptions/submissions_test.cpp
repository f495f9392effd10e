// Stage files as students write them, and what must be named in each: its first line says.
//   // right                        passes the stage's check, and nothing is named
//   // named: nothing               fails, and nothing is named
//   // named: L_reversed            fails, and this is named
//   // named: a + b|c@point         fails, and a is named, and one of b and c, in the point lights
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>
#include <sstream>

#include "catch2.hpp"
#include "diagnosis.hpp"
#include "examine.hpp"
#include "fos/stage_program.hpp"

using namespace fos;

namespace {

struct Submission {
  const Stage* stage = nullptr;
  std::filesystem::path source;
  std::filesystem::path program;
  std::string verdict;  ///< the first line, without the slashes
};

std::vector<Submission> submissions() {
  std::vector<Submission> all;
  std::ifstream list(FOS_SUBMISSIONS);
  for (std::string stage, source, program; list >> stage >> source >> program;) {
    const auto* const found = std::find_if(std::begin(stages), std::end(stages),
                                           [&](const Stage& each) { return each.id == stage; });
    std::ifstream in(source);
    std::string line;
    std::getline(in, line);
    all.push_back({found, source, program, line.substr(std::min<std::size_t>(3, line.size()))});
  }
  return all;
}

Frame ask(const Submission& submission, const SceneText& scene) {
  StageProgram program(submission.program, {std::chrono::seconds(20), 20});
  Frame frame;
  if (program.ask(request_for(scene), frame).ending != Ending::complete) return {};
  return frame;
}

bool passes(const Submission& submission) {
  return examine(Questions(*submission.stage), submission.program, patient_limits()).passes();
}

std::string word(const std::vector<MistakeMade>& findings) {
  std::string words;
  for (const MistakeMade& finding : findings) {
    if (!words.empty()) words += " & ";
    words += misconception(finding.mistake).id;
    if (finding.where == Where::point_lights) words += "@point";
    if (finding.where == Where::directional_lights) words += "@directional";
  }
  return words;
}

/// The terms of a verdict, sorted: `a + c|b` and `b|c + a` say the same.
std::set<std::set<std::string>> terms(const std::string& verdict) {
  std::set<std::set<std::string>> all;
  std::istringstream in(verdict);
  for (std::string token; in >> token;) {
    if (token == "+") continue;
    std::set<std::string> one;
    std::istringstream alternatives(token);
    for (std::string each; std::getline(alternatives, each, '|');) one.insert(each);
    all.insert(one);
  }
  return all;
}

std::string verdict(const Diagnosis& diagnosis) {
  std::string words;
  for (const MistakeMade& finding : diagnosis.certain) {
    words += (words.empty() ? "" : " + ") + word({finding});
  }
  std::string one_of;
  for (const auto& each : diagnosis.one_of) one_of += (one_of.empty() ? "" : "|") + word(each);
  if (!one_of.empty()) words += (words.empty() ? "" : " + ") + one_of;
  return words.empty() ? "nothing" : words;
}

Diagnosis diagnose(const Submission& submission) {
  std::vector<Frame> frames;
  for (const SceneText& scene : diagnostic_scenes(*submission.stage)) {
    frames.push_back(ask(submission, scene));
  }
  return diagnose(*submission.stage, frames);
}

}  // namespace

TEST_CASE("what students write is caught, and named as what it is") {
  const std::string named = "named: ";
  int wrong = 0;
  int caught = 0;
  int nameable = 0;
  int rightly = 0;
  int wrongly = 0;
  const std::vector<Submission> all = submissions();
  REQUIRE(all.size() >= 180);
  for (const Submission& each : all) {
    REQUIRE(each.stage != std::end(stages));
    INFO(each.stage->id << "/" << each.source.filename().string() << ": " << each.verdict);
    const bool passed = passes(each);
    const std::string found = verdict(diagnose(each));
    INFO("found: " << found);
    if (each.verdict == "right") {
      CHECK(passed);
      CHECK(found == "nothing");
      wrongly += found != "nothing" ? 1 : 0;
      continue;
    }
    REQUIRE(each.verdict.substr(0, named.size()) == named);
    const std::string expected = each.verdict.substr(named.size());
    CHECK_FALSE(passed);
    CHECK(terms(found) == terms(expected));
    ++wrong;
    caught += passed ? 0 : 1;
    nameable += expected != "nothing" ? 1 : 0;
    rightly += expected != "nothing" && terms(found) == terms(expected) ? 1 : 0;
    wrongly += found != "nothing" && terms(found) != terms(expected) ? 1 : 0;
  }
  const std::string share = fmt::format(
      "submissions: {} of {} wrong ones caught; {} of {} with catalogued mistakes named rightly, "
      "{} of all {} wrongly\n",
      caught, wrong, rightly, nameable, wrongly, all.size());
  fmt::print("{}", share);
  std::ofstream(FOS_SHARE) << share;
}
