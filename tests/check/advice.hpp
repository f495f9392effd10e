// What a failing stage is told about its mistake.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "diagnosis.hpp"
#include "fos/stage_list.hpp"
#include "fos/stage_program.hpp"

namespace fos {

struct Advice {
  std::string mistake;  ///< its name, or the names; empty where none is found
  /// For each mistake its name, the question that leads to it and where to look; or, where nothing
  /// has a name, what the pixels show of where the chain first goes wrong. Lines, ready to print;
  /// empty where they show nothing.
  std::string words;
  Diagnosis diagnosis;
};

/// What came for scenes, in their order: an empty frame where no whole one did.
using AskFrames = std::function<std::vector<Frame>(const std::vector<SceneText>&)>;

/// Asks for the diagnostic scenes, and looks for the mistake that gives these pixels. Throws where
/// the data of the mistakes cannot be read.
Advice advise(const Stage& stage, const AskFrames& ask);

/// The same of a program. Throws Stopped soon after `stop` asks for it.
Advice advise(const Stage& stage, const std::filesystem::path& program, const Limits& limits,
              const std::stop_token& stop = {});

}  // namespace fos
