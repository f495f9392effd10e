// All that a stage is asked when it is graded, with the right answers: made once, for the whole
// class.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "drawn_scene.hpp"
#include "examine.hpp"
#include "judge.hpp"

namespace fos::grading {

/// The scenes of one seed, and their certified references, for every stage.
struct DrawnScenes {
  struct Drawn {
    DrawnScene scene;
    SceneText text;
    reference::Reference reference;
  };
  std::vector<Drawn> scenes;

  explicit DrawnScenes(std::uint64_t seed);
  static constexpr int count = 4;
};

class StageQuestions {
 public:
  StageQuestions(const Stage& stage, const DrawnScenes& drawn);

  const Stage& stage() const { return public_.stage(); }
  /// The public checks.
  const Questions& checks() const { return public_; }
  /// Of the drawn scenes, in their order.
  const std::vector<std::shared_ptr<const Judge>>& drawn() const { return drawn_; }
  /// The drawn scene that a relation changes: its number.
  static std::size_t base_of(Relation relation) {
    return static_cast<std::size_t>(relation) % DrawnScenes::count;
  }

  /// What to ask: the scenes of the checks, the drawn ones, and one changed for each relation.
  const std::vector<SceneText>& scenes() const { return scenes_; }
  std::size_t first_drawn() const { return public_.scenes().size(); }
  std::size_t place(Relation relation) const {
    return first_drawn() + drawn_.size() + static_cast<std::size_t>(relation);
  }

 private:
  Questions public_;
  std::vector<std::shared_ptr<const Judge>> drawn_;
  std::vector<SceneText> scenes_;
};

/// Whether `other`, of the changed scene, is what `base` foretells, where only one answer is right
/// there. Proves nothing of a base that is wrong. `lit`: the stage's colors are times some I.
bool holds(Relation relation, bool lit, const Judge& judge, const Frame& base, const Frame& other);

}  // namespace fos::grading
