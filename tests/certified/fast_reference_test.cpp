// References by the machine's intervals are the oracle's, field for field.
#include "fast_reference.hpp"

#include <filesystem>

#include "catch2.hpp"
#include "compare_references.hpp"
#include "random_scene.hpp"

using namespace fos;
using namespace fos::certified;

namespace {

SceneText scene_of(const std::string& lines) { return parse_scene_text(lines, "test"); }

}  // namespace

TEST_CASE("all committed data come out again, whole") {
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator(FOS_REFERENCE_DATA)) {
    INFO(file.path().filename().string());
    const reference::Reference committed = reference::read_reference(file.path());
    const SceneText scene = scene_of(committed.scene_text);
    ReferenceEffort effort;
    const bool same = certified::reference(scene, &effort) == committed;
    CHECK(same);
    // Were they left to the oracle, this test would prove little.
    CHECK(effort.by_oracle * 100 < static_cast<long>(committed.pixels.size()));
    CHECK(effort.with_mpfi == 0);
    ++files;
  }
  CHECK(files > 0);
}

TEST_CASE("random scenes have the generator's reference, or its error") {
  for (std::uint64_t number = 0; number < 40; ++number) {
    INFO("scene " << number);
    CHECK(compare_references(scene_of(random_scene(number, 9))) == ReferenceComparison::equal);
  }
}

TEST_CASE("canvases of all shapes") {
  const std::string lines =
      "sphere { center = (0, -1, 3) radius = 1 color = (255, 0, 0) }\n"
      "sphere { center = (0.2, 0, 4) radius = 1.5 color = (0, 127.5, 255) }\n"
      "light { type = ambient intensity = 1 }\n"
      "light { type = point intensity = 0.6 position = (2, 1, 0) }\n";
  for (const std::string size : {"1 x 1", "1 x 9", "13 x 2", "5 x 5"}) {
    INFO(size);
    CHECK(compare_references(scene_of("canvas_size = " + size + "\n" + lines)) ==
          ReferenceComparison::equal);
  }
}

TEST_CASE("what only a float may see is seen") {
  // The ray ahead passes through it so near to its edge that a float may say that it misses.
  const SceneText scene = scene_of(
      "canvas_size = 2 x 2\n"
      "sphere { center = (0, 1, 3) radius = 1.00000001 color = (255, 0, 0) }\n"
      "light { type = directional intensity = 1 direction = (1, -4, -4) }\n");
  const reference::Reference fast = certified::reference(scene);
  REQUIRE(fast.ambiguous[0].size() == 1);
  CHECK(fast.ambiguous[0][0].alternatives == std::vector{reference::StoredAlternative{}});
  CHECK(fast.ambiguous[1].empty());
  CHECK(compare_references(scene) == ReferenceComparison::equal);
}

TEST_CASE("what the machine's numbers cannot carry goes to the oracle") {
  const std::string lines =
      "canvas_size = 4 x 4\n"
      "sphere { center = (0, 0, 3) radius = 0.5 color = (255, 0, 0) }\n";
  const auto effort_of = [](const SceneText& scene) {
    ReferenceEffort effort;
    certified::reference(scene, &effort);
    return std::pair(effort.by_oracle.load(), effort.with_mpfi.load());
  };
  // In float the length of L is out of range; then the position too, and in double the length.
  for (const std::string distance : {"1e30", "1e200"}) {
    const SceneText scene = scene_of(
        lines + "light { type = point intensity = 1 position = (0, 1, -" + distance + ") }\n");
    CHECK(compare_references(scene) == ReferenceComparison::equal);
    const auto [by_oracle, with_mpfi] = effort_of(scene);
    CHECK(with_mpfi > 0);
    CHECK((by_oracle < 16) == (distance == "1e30"));  // the background needs no light
  }
  // In both the center itself: nothing can be said of any pixel.
  const SceneText far = scene_of(lines +
                                 "sphere { center = (0, 0, 1e400) radius = 1e399 "
                                 "color = (1, 2, 3) }\n");
  CHECK(compare_references(far) == ReferenceComparison::equal);
  CHECK(effort_of(far) == std::pair(16L, 16L));
}

TEST_CASE("errors are the generator's") {
  const std::string sphere = "sphere { center = (0, 0, 3) radius = 1 color = (255, 255, 255) }\n";
  for (const std::string& lines :
       {"canvas_size = 2000 x 2000\n" + sphere,  // more pixels than there may be
        sphere + "light { type = point intensity = 1e-400 position = (2, 1, 0) }\n",
        // Two irrational terms whose sum is exactly between two bytes: tests/reference has why.
        std::string("canvas_size = 2 x 2\n"
                    "sphere { center = (-4, 0, 6) radius = 1.5 color = (200, 0, 0) }\n"
                    "light { type = directional intensity = 0.11875 direction = (3, 0, 4) }\n"
                    "light { type = directional intensity = 0.771875 direction = (12, 0, 5) }")}) {
    INFO(lines);
    CHECK(compare_references(scene_of(lines)) == ReferenceComparison::same_error);
  }
}
