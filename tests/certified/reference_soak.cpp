// reference_soak FIRST COUNT [SIZE]: the references of random scenes from number FIRST on, by the
// machine's intervals and by the oracle. At the first difference it stops, with exit status 1.
#include <fmt/core.h>

#include <cstdlib>

#include "compare_references.hpp"
#include "random_scene.hpp"

int main(int argc, char** argv) {
  using namespace fos;
  if (argc < 3) {
    fmt::print(stderr, "usage: reference_soak FIRST COUNT [SIZE]\n");
    return 2;
  }
  const long first = std::atol(argv[1]);
  const long end = first + std::atol(argv[2]);
  const int size = argc > 3 ? std::atoi(argv[3]) : 16;
  long errors = 0;
  for (long number = first; number < end; ++number) {
    const SceneText scene = parse_scene_text(
        certified::random_scene(static_cast<std::uint64_t>(number), size), "random");
    switch (certified::compare_references(scene)) {
      case certified::ReferenceComparison::equal:
        break;
      case certified::ReferenceComparison::same_error:
        ++errors;
        break;
      case certified::ReferenceComparison::different:
        fmt::print("scene {} has another reference\n{}\n", number, scene.source);
        return 1;
    }
  }
  fmt::print("{} scenes, {} of them refused by both\n", end - first, errors);
  return 0;
}
