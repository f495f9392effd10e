#include "asked_pixel.hpp"

#include "hushed.hpp"
#include "scene_source.hpp"

namespace fos {
namespace {

/// The row that was wanted is there.
struct Enough {};

}  // namespace

Given ask_in_picture(const std::filesystem::path& program, const SceneText& scene, int column,
                     int row, Limits limits) {
  Given given;
  Hushed hushed;
  try {
    StageProgram stage(program, limits);
    given.answer = stage.ask(
        request_for(scene), [&](const FrameHeader& header) { given.answer.header = header; },
        [&](int received, const Row& each) {
          if (received != row) return;
          const auto pixel = static_cast<std::size_t>(column);
          for (std::size_t i = 0; i < 3; ++i) given.channels[i] = each.channels[3 * pixel + i];
          given.unwritten = each.unwritten[pixel] != 0;
          throw Enough();
        });
  } catch (const Enough&) {
    given.answer.rows = row + 1;
  }
  given.words = hushed.take_words();
  return given;
}

Given ask_alone(const std::filesystem::path& program, const SceneText& scene, int column, int row,
                Limits limits) {
  const OneRay ray = one_ray(scene, column, row);
  Given given = ask_in_picture(program, ray.scene, ray.column, ray.row, limits);
  if (given.answer.ending != Ending::refused) return given;
  return ask_in_picture(program, scene, column, row, limits);
}

}  // namespace fos
