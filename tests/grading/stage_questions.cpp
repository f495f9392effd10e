#include "stage_questions.hpp"

#include <algorithm>
#include <cmath>

#include "fast_reference.hpp"

namespace fos::grading {
namespace {

reference::Precision precision_of(const Frame& frame) {
  return frame.header.precision == Precision::binary32 ? reference::Precision::float24
                                                       : reference::Precision::double53;
}

/// Within what two roundings of float differ; above 255 there is only white.
bool equal(long double a, long double b) {
  return std::abs(std::min(a, 255.0L) - std::min(b, 255.0L)) <= 0.02L;
}

}  // namespace

DrawnScenes::DrawnScenes(std::uint64_t seed) {
  for (int i = 0; i < count; ++i) {
    DrawnScene scene = draw_scene(seed, i);
    SceneText text = parse_scene_text(scene.text(), "drawn");
    reference::Reference reference = certified::reference(text);
    scenes.push_back({std::move(scene), std::move(text), std::move(reference)});
  }
}

StageQuestions::StageQuestions(const Stage& stage, const DrawnScenes& drawn) : public_(stage) {
  scenes_ = public_.scenes();
  for (const auto& each : drawn.scenes) {
    drawn_.push_back(std::make_shared<const Judge>(each.reference, stage.terms));
    scenes_.push_back(each.text);
  }
  for (const Relation relation : relations) {
    const DrawnScene scene = changed(drawn.scenes[base_of(relation)].scene, relation);
    scenes_.push_back(parse_scene_text(scene.text(), "changed"));
  }
}

bool holds(Relation relation, bool lit, const Judge& judge, const Frame& base, const Frame& other) {
  const auto& [width, height, _] = base.header;
  for (int row = 0; row < height; ++row) {
    for (int column = relation == Relation::mirrored ? 1 : 0; column < width; ++column) {
      const std::vector<Expected> expected = judge.expected({column, row}, precision_of(base));
      if (expected.size() != 1) continue;
      const auto from = base.pixel(column, row);
      const auto to = other.pixel(relation == Relation::mirrored ? width - column : column, row);
      const bool halved = relation == Relation::dimmed && lit && expected[0].sphere != 0;
      for (std::size_t i = 0; i < from.size(); ++i) {
        if (!std::isfinite(to[i])) return false;
        // A stage may cut off at 255 by itself: what was there before is not known.
        if (halved && from[i] >= 255) continue;
        if (!equal(halved ? from[i] / 2 : from[i], to[i])) return false;
      }
    }
  }
  return true;
}

}  // namespace fos::grading
