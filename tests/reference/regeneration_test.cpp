// A part of each scene, certified anew, is what was committed.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch2.hpp"
#include "exact_scene.hpp"
#include "oracle.hpp"
#include "reference_file.hpp"

using namespace fos::reference;

namespace {

/// The scene file that belongs to a reference; empty if there is none.
std::string scene_file(const std::string& name) {
  for (const char* folder : {FOS_LAB_SCENES, FOS_TEST_SCENES}) {
    std::ifstream file(std::filesystem::path(folder) / (name + ".scene"), std::ios::binary);
    if (file) return {std::istreambuf_iterator<char>(file), {}};
  }
  return {};
}

/// What the reference accepts beside the certified answer, if anything.
std::optional<AmbiguousPixel> ambiguous_at(const std::vector<AmbiguousPixel>& list, int pixel) {
  for (const AmbiguousPixel& entry : list) {
    if (entry.pixel == pixel) return entry;
  }
  return std::nullopt;
}

/// Certifies every `stride`-th pixel, and those where several answers are right.
void check_part(const Reference& reference, int stride) {
  const ExactScene scene = to_exact(fos::parse_scene_text(reference.scene_text, "scene"));
  const Oracle oracle(scene, reference.step);
  const auto check_pixel = [&](int pixel) {
    CAPTURE(pixel % reference.width, pixel / reference.width);
    const PixelTruth truth = oracle.truth(pixel % reference.width, pixel / reference.width);
    CHECK(truth.pixel == reference.pixels[static_cast<std::size_t>(pixel)]);
    for (std::size_t i = 0; i < precisions.size(); ++i) {
      CHECK(truth.ambiguous[i] == ambiguous_at(reference.ambiguous[i], pixel));
    }
  };
  for (int pixel = 0; pixel < reference.width * reference.height; pixel += stride) {
    check_pixel(pixel);
  }
  for (const AmbiguousPixel& entry : reference.ambiguous[0]) check_pixel(entry.pixel);
  for (const AmbiguousPixel& entry : reference.ambiguous[1]) check_pixel(entry.pixel);
}

}  // namespace

TEST_CASE("the committed data come out again") {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FOS_REFERENCE_DATA)) {
    const std::string name = entry.path().stem().string();
    CAPTURE(name);
    const Reference reference = read_reference(entry.path());
    CHECK(scene_file(name) == reference.scene_text);
    check_part(reference, reference.pixels.size() > 100000 ? 97 : 5);
    ++files;
  }
  CHECK(files > 0);
}
