// Without a mistake the tracer that makes them is right, and float and double agree on every set of
// the data.
#include <cmath>

#include "catch2.hpp"
#include "diagnosis.hpp"
#include "explanation.hpp"
#include "judge.hpp"
#include "light_code.hpp"
#include "make_mistakes.hpp"
#include "scene_at.hpp"
#include "stage_frames.hpp"

using namespace fos;

TEST_CASE("with no mistake every reference scene is right") {
  const std::filesystem::path data = FOS_REFERENCE_DATA;
  for (const Stage& stage : stages) {
    for (const std::string_view scene : stage.scenes) {
      if (scene == "lecture" && stage.id != "combined") continue;  // the largest, once
      const Judge judge(reference::read_reference(data / (std::string(scene) + ".ref")),
                        stage.terms);
      INFO(stage.id << " " << scene);
      CHECK(judge.judge(mistaken_frame(SceneAt<double>(judge.scene()), stage.terms, {})).passes());
      CHECK(judge.judge(mistaken_frame(SceneAt<float>(judge.scene()), stage.terms, {})).passes());
    }
  }
}

TEST_CASE("every set of the data explains the tracer's frames, at float and at double") {
  for (const Stage& stage : stages) {
    const StageMistakes& data = mistakes_of(stage);
    const Explainer explainer(data);
    std::size_t not_compared = 0;
    for (const Plane& plane : data.planes) {
      MistakeSet mistakes;
      if (plane.first) mistakes.add(*plane.first);
      if (plane.second) mistakes.add(*plane.second);
      const auto at_double = Evidence::of(mistaken_frames<double>(stage, mistakes));
      const auto at_float = Evidence::of(mistaken_frames<float>(stage, mistakes));
      CHECK(explainer.explains(plane, {}, *at_double));
      CHECK(explainer.explains(plane, {}, *at_float));
      not_compared = std::max(not_compared, plane.not_compared.size());
    }
    INFO(stage.id << ": at most " << not_compared << " pixels are not compared");
    CHECK(not_compared <= 40);
  }
}

TEST_CASE("a code is the cell that its value lies in") {
  for (const double I : {0.0, 1e-9, 0.17, 0.5, 0.999, 1.0, 1.3, 5.0, 17.9}) {
    for (const double value : {I, -I}) {
      const LightCell cell = light_cell(light_code(value));
      INFO(value);
      CHECK(cell.low <= value);
      CHECK(value <= cell.high);
      CHECK(cell.high - cell.low <= 0.0024 * std::max(1.0, std::abs(value)));
    }
  }
  CHECK(light_cell(light_code(1e9)).high == std::numeric_limits<double>::infinity());
  CHECK(light_cell(light_code(-1e9)).low == -std::numeric_limits<double>::infinity());
  CHECK(light_code(std::nan("")) == not_a_number_code);
}

TEST_CASE("data that are damaged, cut or of other scenes are refused") {
  const Stage& stage = stages[1];
  std::vector<SceneText> scenes = base_scenes();
  const std::string file = encode(make_mistakes(stage), scenes);
  CHECK(decode(file, scenes).planes.size() == mistakes_of(stage).planes.size());
  CHECK_THROWS_AS(decode(file.substr(0, file.size() / 2), scenes), MistakeDataError);
  CHECK_THROWS_AS(decode("", scenes), MistakeDataError);
  std::string damaged = file;
  damaged[file.size() / 2] = static_cast<char>(damaged[file.size() / 2] ^ 1);
  CHECK_THROWS_AS(decode(damaged, scenes), MistakeDataError);
  scenes[0].source += "# another\n";
  CHECK_THROWS_AS(decode(file, scenes), MistakeDataError);
}
