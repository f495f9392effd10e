// A stage of the student's on the ladder: a program that is asked, like everywhere else.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "fos/stage_list.hpp"
#include "rung.hpp"

namespace fos::numerics {

/// Why a stage cannot be measured, in words, and the exit status: 1 the stage, 2 the scene, 3 ours.
class StageError : public std::runtime_error {
 public:
  StageError(int status, const std::string& message)
      : std::runtime_error(message), exit_status(status) {}
  int exit_status;
};

/// The programs of a stage: lab_ID, lab_ID_float, lab_ID_extended and the empty stage's, in
/// `folder`.
struct StagePrograms {
  const Stage* stage;
  std::filesystem::path folder;
};

/// Asks the stage at each precision for a small picture. Throws StageError where it is no use to
/// measure it: a stage that is not written, crashes or never ends, a scene that double cannot
/// carry. Returns the precisions that can carry the scene; `notes` hears of the others.
std::vector<Precision> usable_precisions(const StagePrograms& programs, const SceneText& scene,
                                         std::vector<std::string>& notes);

/// Adds for each precision the stage's rung, and the empty stage's as its toll. `scene` is the file
/// as it was read, but for its canvas. Their render throws StageError.
void add_stage_rungs(std::vector<Rung>& rungs, const StagePrograms& programs,
                     const std::vector<Precision>& precisions, const SceneText& scene);

}  // namespace fos::numerics
