#include "advice.hpp"

#include <algorithm>

#include "asked.hpp"
#include "diagnosis.hpp"
#include "fos/text.hpp"
#include "layout.hpp"
#include "locate.hpp"

namespace fos {

Advice advise(const Stage& stage, const AskFrames& ask) {
  const std::vector<Frame> came = ask(diagnostic_scenes(stage));
  const Diagnosis diagnosis = diagnose(stage, came);
  Advice advice{"", "", diagnosis};
  if (diagnosis.named()) {
    advice.mistake = names(diagnosis);
    advice.words = say(text::check_mistake) + "\n";
    for (const std::string& line : describe(diagnosis)) advice.words += wrapped(line, 2);
    return advice;
  }
  std::vector<SceneText> single;
  for (const TermScene& term : term_scenes(stage)) single.push_back(term.scene);
  const Location location = locate(stage, came, ask(single));
  if (!location.words.empty()) advice.words = say(text::check_no_mistake) + "\n";
  for (const std::string& sentence : location.words) advice.words += wrapped(sentence, 2);
  return advice;
}

Advice advise(const Stage& stage, const std::filesystem::path& program, const Limits& limits,
              const std::stop_token& stop) {
  return advise(stage, [&](const std::vector<SceneText>& scenes) {
    return frames_of(ask_all(program, limits, scenes, stop));
  });
}

}  // namespace fos
