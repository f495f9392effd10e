// Every mistake is named, alone and with each other, and nothing that is not made is.
#include "diagnosis.hpp"

#include <algorithm>
#include <map>

#include "catch2.hpp"
#include "mistake_data.hpp"
#include "scene_at.hpp"

using namespace fos;

namespace {

template <typename T>
std::vector<Frame> frames_of(const Stage& stage, const MistakeSet& mistakes) {
  std::vector<Frame> frames;
  for (const SceneText& scene : diagnostic_scenes(stage)) {
    frames.push_back(mistaken_frame(SceneAt<T>(scene), stage.terms, mistakes));
  }
  return frames;
}

/// Whether these mistakes are what the diagnosis says, or one of the things that it may be.
bool names(const Diagnosis& diagnosis, const MistakeSet& mistakes) {
  const auto complete = [&](std::vector<Finding> findings) {
    findings.insert(findings.end(), diagnosis.certain.begin(), diagnosis.certain.end());
    MistakeSet named;
    for (const Finding& finding : findings) named.add(finding.mistake);
    return named == mistakes;
  };
  if (diagnosis.one_of.empty()) return complete({});
  return std::any_of(diagnosis.one_of.begin(), diagnosis.one_of.end(), complete);
}

std::string words(const Diagnosis& diagnosis) {
  std::string all;
  for (const Finding& finding : diagnosis.certain) {
    all.append(misconception(finding.mistake).id).append(" ");
  }
  for (const auto& each : diagnosis.one_of) {
    all.append("| ");
    for (const Finding& finding : each) all.append(misconception(finding.mistake).id).append(" ");
  }
  return all.empty() ? "nothing" : all;
}

}  // namespace

TEST_CASE("every mistake is named, at double and at float") {
  for (const Stage& stage : stages) {
    for (const Misconception& each : misconceptions()) {
      if ((each.stages & stage_bit(stage.id)) == 0) continue;
      const MistakeSet made{each.mistake};
      const Diagnosis at_double = diagnose(stage, frames_of<double>(stage, made));
      INFO(stage.id << " " << each.id << ": " << words(at_double));
      CHECK(names(at_double, made));
      const Diagnosis at_float = diagnose(stage, frames_of<float>(stage, made));
      INFO("at float: " << words(at_float));
      CHECK(names(at_float, made));
    }
  }
}

TEST_CASE("pairs") {
  for (const Stage& stage : stages) {
    int named=0, all=0, simpler=0, wrong=0;
    std::map<std::string,int> un;
    for (const Misconception& a : misconceptions()) for (const Misconception& b : misconceptions()) {
      if (!(a.mistake<b.mistake) || a.slot==b.slot) continue;
      if ((a.stages & b.stages & stage_bit(stage.id)) == 0) continue;
      const MistakeSet made{a.mistake,b.mistake};
      const Diagnosis d = diagnose(stage, frames_of<double>(stage, made));
      ++all;
      if (names(d, made)) ++named; else if (!d.named()) { ++wrong; ++un[std::string(a.id)]; ++un[std::string(b.id)]; } else ++simpler;
    }
    printf("%s pairs %d named %d simpler %d nothing %d\n", std::string(stage.id).c_str(), all, named, simpler, wrong);
    for (auto&[k,v]:un) if(v>5) printf("   %s %d\n",k.c_str(),v);
  }
}
