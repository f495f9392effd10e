// How well the diagnostic scenes tell the mistakes apart: for each mistake of each stage the one
// that is nearest to it, and how many pixels differ. 0 are alike. The table is committed, so that
// nothing becomes alike unnoticed.
#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "catch2.hpp"
#include "diagnosis.hpp"
#include "explanation.hpp"
#include "stage_frames.hpp"

using namespace fos;

namespace {

/// A mistake of a stage as the data have it: a plane, or the right one with another finish.
struct Single {
  const Misconception* mistake;
  const Plane* plane;
  MistakeSet finish;
};

std::vector<Single> singles_of(const Stage& stage) {
  const StageMistakes& data = mistakes_of(stage);
  std::vector<Single> singles;
  for (const Misconception& each : misconceptions()) {
    if ((each.stages & stage_bit(stage.id)) == 0) continue;
    Single single{&each, data.planes.data(), {each.mistake}};
    for (const Plane& plane : data.planes) {
      if (plane.first == each.mistake && !plane.second) single = {&each, &plane, {}};
    }
    singles.push_back(single);
  }
  return singles;
}

std::string table() {
  std::string lines =
      "# stage, mistake, the mistake nearest to it, the pixels that tell them apart (of 1728)\n";
  for (const Stage& stage : stages) {
    const Explainer explainer(mistakes_of(stage));
    const std::vector<Single> singles = singles_of(stage);
    for (const Single& made : singles) {
      const auto evidence = Evidence::of(mistaken_frames<double>(stage, {made.mistake->mistake}));
      std::size_t least = evidence->size();
      std::string nearest;
      for (const Single& other : singles) {
        if (other.mistake == made.mistake) continue;
        const std::size_t misses =
            explainer.misses(*other.plane, other.finish, *evidence, least + 1);
        if (misses > least) continue;
        if (misses < least) nearest.clear();
        nearest += fmt::format("{}{}", nearest.empty() ? "" : ",", other.mistake->id);
        least = misses;
      }
      lines += fmt::format("{} {} {} {}\n", stage.id, made.mistake->id, nearest, least);
    }
  }
  return lines;
}

}  // namespace

TEST_CASE("what can be told apart stays so") {
  std::ifstream in(FOS_ALIKE);
  const std::string committed{std::istreambuf_iterator<char>(in), {}};
  const std::string now = table();
  if (now != committed) std::ofstream(FOS_ALIKE_NOW) << now;
  INFO("the table as it is now: " << FOS_ALIKE_NOW);
  CHECK(now == committed);
}
