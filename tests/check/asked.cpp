#include "asked.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

namespace fos {

std::vector<Asked> ask_all(const std::filesystem::path& program, const Limits& limits,
                           const std::vector<SceneText>& scenes) {
  std::vector<Asked> all(scenes.size());
  std::atomic<std::size_t> next{0};
  std::atomic<bool> hopeless{false};
  const auto work = [&] {
    for (std::size_t i = next++; i < scenes.size() && !hopeless; i = next++) {
      StageProgram one(program, limits);
      all[i].answer = one.ask(request_for(scenes[i]), all[i].frame);
      all[i].printed = one.words();
      all[i].asked = true;
      if (all[i].answer.ending == Ending::timed_out) hopeless = true;
    }
  };
  std::vector<std::jthread> workers;
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  while (workers.size() + 1 < std::min(processors, scenes.size())) workers.emplace_back(work);
  work();
  workers.clear();
  return all;
}

}  // namespace fos
