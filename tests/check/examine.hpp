// A stage program put to everything that its test asks: what it does, what it does not, and why.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "asked.hpp"
#include "fos/stage_program.hpp"
#include "judge.hpp"
#include "stage_test.hpp"

namespace fos {

enum class Outcome {
  passed,
  failed,
  not_judged  ///< not asked any more, once an answer never came
};

/// A pixel of a scene, to be looked at again.
struct Spot {
  std::string scene_text;  ///< empty for the lecture's scene
  Pixel pixel;
};

/// One line of a check: something that the stage must do.
struct Finding {
  std::string words;
  Outcome outcome = Outcome::passed;
  int passed = 0;  ///< of `things`: the scenes are counted one by one
  int things = 1;
  std::string why;  ///< for what failed: the first pixel, what is expected there and what came
  std::optional<Spot> spot;  ///< that pixel, if a frame came
};

/// The scene that a picture of the check shows, and the pixel to look at first.
struct Shown {
  std::string scene_name;
  std::shared_ptr<const Judge> judge;
  std::shared_ptr<const Frame> frame;
  Verdict verdict;
};

struct Findings {
  const Stage* stage = nullptr;
  std::vector<Finding> list;
  int passed = 0;  ///< the sum over the list
  int things = 0;
  std::string note;            ///< for a stage that passes: right to float precision only
  std::string printed;         ///< what the program printed where it first ended without a frame
  std::optional<Shown> shown;  ///< the lecture's scene, or the first that is wrong; nothing where
                               ///< no frame came
  bool passes() const { return passed == things; }
  /// Tenths of a point, rounded down, so that only what is whole gives all.
  int tenths() const { return things == 0 ? 0 : 10 * stage->points * passed / things; }
};

/// What a stage is asked, and the right answers: read once, for any number of programs.
class Questions {
 public:
  /// Throws where a reference cannot be read.
  explicit Questions(const Stage& stage);

  const Stage& stage() const { return *stage_; }
  const StageTest& test() const { return *test_; }
  /// One for each of the stage's scenes.
  const std::vector<std::shared_ptr<const Judge>>& judges() const { return judges_; }
  /// Each scene once, the large ones first, so that no processor is left waiting for one at the
  /// end.
  const std::vector<SceneText>& scenes() const { return scenes_; }
  /// Where its scene stands among them.
  std::size_t place(const Judge& judge) const { return places_.at(judge.scene().source); }
  std::size_t place(const PixelCase& pixel) const {
    return places_.at(pixel.scene.empty() ? lecture_.source : pixel.scene);
  }

 private:
  SceneText scene(const PixelCase& pixel) const;
  void add(const SceneText& scene);

  const Stage* stage_;
  const StageTest* test_;
  SceneText lecture_;
  std::vector<std::shared_ptr<const Judge>> judges_;
  std::vector<SceneText> scenes_;
  std::map<std::string, std::size_t> places_;  // by their text
};

/// Asks `program` for every scene, each by a fresh copy, since a stage may keep statics; several at
/// a time. Throws where the program is not there, and Stopped soon after `stop` asks for it.
Findings examine(const Questions& questions, const std::filesystem::path& program,
                 const Limits& limits, const std::stop_token& stop = {});

/// The same, of what came for the questions' scenes.
Findings examine(const Questions& questions, const std::vector<Asked>& answers);

/// The limits that end what never ends, and fail nobody on a busy machine.
Limits patient_limits();

}  // namespace fos
