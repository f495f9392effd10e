// Many scenes asked of a stage at once, as many at a time as there are processors.
#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "fos/stage_program.hpp"

namespace fos {

/// What came for one scene.
struct Asked {
  bool asked = false;  ///< no scene is asked for once an answer has timed out
  Answer answer;
  std::shared_ptr<const Frame> frame;  ///< as much of it as came
  std::string printed;

  bool is_whole() const { return asked && answer.ending == Ending::complete; }
};

/// What came, in the same order: an empty frame where it is not whole.
std::vector<Frame> frames_of(const std::vector<Asked>& answers);

/// Thrown where the answers are not wanted any more.
struct Stopped : std::exception {
  const char* what() const noexcept override { return "stopped"; }
};

/// In any order, each by a fresh copy of the program; the answers are in the scenes' order. Throws
/// Stopped soon after `stop` asks for it.
std::vector<Asked> ask_all(const std::filesystem::path& program, const Limits& limits,
                           const std::vector<SceneText>& scenes, const std::stop_token& stop = {});

}  // namespace fos
