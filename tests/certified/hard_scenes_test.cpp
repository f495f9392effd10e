// Scenes that found a hole in the proof once (each says which), and ordinary random ones: on every
// instruction set that this machine has, for each has roundings and estimates of its own.
#include <hwy/targets.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "catch2.hpp"
#include "compare.hpp"
#include "float_row.hpp"
#include "random_scene.hpp"

using namespace fos;
using namespace fos::certified;

namespace {

constexpr reference::Terms all_light =
    reference::ambient | reference::point | reference::directional;

/// Lets float_row run as on a machine that has only this instruction set.
void use_only(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().DeInit();
}

/// One bit a set: those that the kernel is compiled for and the machine has.
std::vector<std::int64_t> instruction_sets() {
  std::vector<std::int64_t> sets;
  std::vector<std::string> names;
  use_only(0);  // 0: what there is
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    use_only(target);
    // A set that the kernel is not compiled for falls back to another.
    const std::string name = float_row_target();
    if (name != hwy::TargetName(target)) continue;
    sets.push_back(target);
  }
  use_only(0);
  return sets;
}

struct AllAgain {
  AllAgain() = default;
  ~AllAgain() { use_only(0); }
  AllAgain(const AllAgain&) = delete;
  AllAgain& operator=(const AllAgain&) = delete;
};

void check(const SceneText& scene, bool by_general_plan) {
  const Comparison result = certified::compare(scene, all_light, by_general_plan);
  INFO(scene.name << " on " << float_row_target() << ": " << result.first);
  CHECK(result.is_sound());
}

}  // namespace

TEST_CASE("the kernel runs on every instruction set that it is compiled for") {
  const AllAgain at_the_end;
  const std::vector<std::int64_t> sets = instruction_sets();
  CHECK_FALSE(sets.empty());
#if defined(__x86_64__)
  CHECK(sets.size() > 1);  // SSSE3 at least, beside the baseline
#endif
}

TEST_CASE("scenes that found a hole once") {
  const AllAgain at_the_end;
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(FOS_HARD_SCENES)) {
    files.push_back(file.path());
  }
  CHECK(files.size() >= 12);
  for (const std::int64_t target : instruction_sets()) {
    use_only(target);
    for (const std::filesystem::path& file : files) {
      const SceneText scene = read_scene_text(file);
      check(scene, false);
      if (scene.canvas_width < 1000) check(scene, true);
    }
  }
}

TEST_CASE("random scenes on every instruction set") {
  const AllAgain at_the_end;
  for (const std::int64_t target : instruction_sets()) {
    use_only(target);
    for (std::uint64_t number = 300; number < 325; ++number) {
      check(parse_scene_text(random_scene(number, 17), "random " + std::to_string(number)), false);
    }
  }
}
