#include "stage_under_test.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "fos/stage_program.hpp"
#include "fos/text.hpp"
#include "judge.hpp"
#include "report.hpp"

namespace fos {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The frame of a scene. Each is asked of a new process, since a stage may keep statics.
Frame ask(const SceneText& scene) {
  static std::string hopeless;  // what never ended once is not waited for again
  if (!hopeless.empty()) FAIL(hopeless);
  // The limits are generous: they end what never ends, and fail nobody on a busy machine.
  StageProgram program(variable("FOS_PROGRAM"), {std::chrono::seconds(60), 60});
  Frame frame;
  const Answer answer = program.ask(request_for(scene), frame);
  if (answer.ending == Ending::timed_out) hopeless = describe(answer, scene.name);
  if (answer.ending != Ending::complete) FAIL(describe(answer, scene.name));
  return frame;
}

Channels pixel_of(const Frame& frame, int column, int row) {
  const auto channels = frame.pixel(column, row);
  if (frame.is_unwritten(column, row)) FAIL(say(text::check_pixel_unwritten));
  if (!is_finite(channels)) FAIL(say(text::check_pixel_not_finite));
  return {static_cast<double>(channels[0]), static_cast<double>(channels[1]),
          static_cast<double>(channels[2])};
}

const std::filesystem::path& data() {
  static const std::filesystem::path folder = FOS_REFERENCE_DATA;
  return folder;
}

void check_whole_frame(const Stage& stage, std::string_view scene_name) {
  const Judge judge(reference::read_reference(data() / (std::string(scene_name) + ".ref")),
                    stage.terms);
  const Frame frame = ask(judge.scene());
  const Verdict verdict = judge.judge(frame);
  std::string words = describe(judge, frame, verdict, scene_name);
  const std::string images = variable("FOS_IMAGES");
  if (!verdict.passes() && !images.empty()) {
    const auto path =
        std::filesystem::path(images) / fmt::format("{}-{}-check.png", stage.id, scene_name);
    if (write_comparison(variable("FOS_PICTURE"), path, judge, frame)) {
      words += say(text::check_picture, {path.string()}) + "\n";
    }
  }
  INFO(words);
  CHECK(verdict.passes());
  if (verdict.passes() && !words.empty()) WARN(words);
}

}  // namespace

Channels pixel_of(std::string_view scene_text, int column, int row) {
  return pixel_of(ask(parse_scene_text(scene_text, "scene")), column, row);
}

Channels pixel_ahead(std::string_view spheres_and_lights) {
  // x = column - 1, y = -row: column 1, row 0 looks straight along +z.
  const std::string scene =
      fmt::format("canvas_size = 2 x 2\nbackground_color = (0, 0, 0)\n{}", spheres_and_lights);
  return pixel_of(scene, 1, 0);
}

Channels lit(std::string_view lights) {
  return pixel_ahead(fmt::format(
      "sphere {{ center = (0, 0, 3)  radius = 1  color = (200, 100, 50) }}\n{}", lights));
}

void check_channels(const Channels& actual, const Channels& expected) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    INFO("channel " << channel << " of red, green, blue");
    CHECK_THAT(std::min(actual[channel], 255.0),
               WithinAbs(std::min(expected[channel], 255.0), 0.01));
  }
}

Channels lecture_pixel(int column, int row) {
  static const Frame frame = ask(read_scene_text(FOS_LECTURE_SCENE));
  return pixel_of(frame, column, row);
}

void check_whole_frames(std::string_view stage_id) {
  const auto stage = std::find_if(std::begin(stages), std::end(stages),
                                  [&](const Stage& each) { return each.id == stage_id; });
  REQUIRE(stage != std::end(stages));
  for (const std::string_view scene : stage->scenes) check_whole_frame(*stage, scene);
}

}  // namespace fos
