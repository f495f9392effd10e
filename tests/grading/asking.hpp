// A stage program in the box, asked for one scene after the other.
#pragma once

#include <functional>
#include <stdexcept>
#include <vector>

#include "asked.hpp"
#include "fos/stage_program.hpp"

namespace fos::grading {

/// Something of ours failed: never the student's fault. The message is for the instructor.
class InfrastructureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// In the scenes' order. After an answer that never came the rest is not asked. Throws
/// InfrastructureError where the box did not start the program, and what `on_wait` throws.
std::vector<Asked> ask_in_turn(
    StageProgram& program, const std::vector<SceneText>& scenes,
    const std::function<void()>& on_wait = [] {});

}  // namespace fos::grading
