#include "asked.hpp"

#include <atomic>

#include "parallel.hpp"

namespace fos {

std::vector<Frame> frames_of(const std::vector<Asked>& answers) {
  std::vector<Frame> frames;
  frames.reserve(answers.size());
  for (const Asked& asked : answers) frames.push_back(asked.is_whole() ? *asked.frame : Frame());
  return frames;
}

std::vector<Asked> ask_all(const std::filesystem::path& program, const Limits& limits,
                           const std::vector<SceneText>& scenes, const std::stop_token& stop) {
  const auto go_on = [&] {
    if (stop.stop_requested()) throw Stopped();
  };
  std::vector<Asked> all(scenes.size());
  std::atomic<bool> hopeless{false};
  in_parallel(scenes.size(), [&] {
    return [&, one = std::make_unique<StageProgram>(program, limits)](std::size_t i) {
      go_on();
      if (hopeless) return;
      const auto frame = std::make_shared<Frame>();
      all[i].answer = one->ask(request_for(scenes[i]), *frame, go_on);
      all[i].frame = frame;
      all[i].printed = one->words();
      all[i].asked = true;
      if (all[i].answer.ending == Ending::timed_out) hopeless = true;
    };
  });
  go_on();
  return all;
}

}  // namespace fos
