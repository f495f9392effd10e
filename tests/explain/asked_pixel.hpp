// What a stage program gives for one pixel: all that can be known of it from outside.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "fos/stage_program.hpp"

namespace fos {

using LinearChannels = std::array<long double, 3>;  ///< red, green, blue, 0..255 and unclamped

struct Given {
  Answer answer;  ///< complete: the pixel came, whatever would come after it
  LinearChannels channels{};
  bool unwritten = false;
  std::string words;  ///< the first of what the program said on standard error

  bool came() const { return answer.ending == Ending::complete; }
};

/// The pixel as a part of the picture: the program renders the scene up to its row. Every
/// question is one to a new process, for a stage may keep statics.
Given ask_in_picture(const std::filesystem::path& program, const SceneText& scene, int column,
                     int row, Limits limits);

/// The pixel's ray by itself (scene_source.hpp): the same O, D and scene in a millisecond.
/// Where the scene bears no such canvas, in the picture.
Given ask_alone(const std::filesystem::path& program, const SceneText& scene, int column, int row,
                Limits limits);

}  // namespace fos
