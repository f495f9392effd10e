#include "asking.hpp"

#include "report.hpp"

namespace fos::grading {

std::vector<Asked> ask_in_turn(StageProgram& program, const std::vector<SceneText>& scenes,
                               const std::function<void()>& on_wait) {
  std::vector<Asked> all(scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto frame = std::make_shared<Frame>();
    all[i].answer = program.ask(request_for(scenes[i]), *frame, on_wait);
    all[i].frame = frame;
    all[i].asked = true;
    const Ending ending = all[i].answer.ending;
    if (ending == Ending::did_not_start) {
      throw InfrastructureError(describe(all[i].answer, scenes[i].name));
    }
    if (ending != Ending::complete) all[i].printed = program.words();
    if (ending == Ending::timed_out) break;
  }
  return all;
}

}  // namespace fos::grading
