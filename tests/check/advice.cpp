#include "advice.hpp"

#include <algorithm>

#include "asked.hpp"
#include "diagnosis.hpp"
#include "fos/text.hpp"
#include "layout.hpp"
#include "locate.hpp"

namespace fos {
namespace {

/// What came, an empty frame where none did.
std::vector<Frame> frames(const std::filesystem::path& program, const Limits& limits,
                          const std::vector<SceneText>& scenes, const std::stop_token& stop) {
  std::vector<Frame> all;
  for (const Asked& asked : ask_all(program, limits, scenes, stop)) {
    const bool whole = asked.asked && asked.answer.ending == Ending::complete;
    all.push_back(whole ? *asked.frame : Frame());
  }
  return all;
}

}  // namespace

Advice advise(const Stage& stage, const std::filesystem::path& program, const Limits& limits,
              const std::stop_token& stop) {
  const std::vector<Frame> came = frames(program, limits, diagnostic_scenes(stage), stop);
  const Diagnosis diagnosis = diagnose(stage, came);
  Advice advice;
  if (diagnosis.named()) {
    advice.mistake = names(diagnosis);
    advice.words = say(text::check_mistake) + "\n";
    for (const std::string& line : describe(diagnosis)) advice.words += wrapped(line, 2);
    return advice;
  }
  std::vector<SceneText> single;
  for (const TermScene& term : term_scenes(stage)) single.push_back(term.scene);
  const Location location = locate(stage, came, frames(program, limits, single, stop));
  if (!location.words.empty()) advice.words = say(text::check_no_mistake) + "\n";
  for (const std::string& sentence : location.words) advice.words += wrapped(sentence, 2);
  return advice;
}

}  // namespace fos
