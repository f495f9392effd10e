// The committed data of the lecture's scene: what is known of it from elsewhere.
#include <algorithm>
#include <array>
#include <vector>

#include "catch2.hpp"
#include "certified_frame.hpp"
#include "reference_file.hpp"

using namespace fos::reference;

namespace {

const Reference& lecture() {
  static const Reference reference =
      read_reference(std::filesystem::path(FOS_REFERENCE_DATA) / "lecture.ref");
  return reference;
}

constexpr Terms combined = ambient | point | directional;

struct Bytes {
  explicit Bytes(Terms terms)
      : bytes(certified_frame(to_exact(fos::parse_scene_text(lecture().scene_text, "lecture")),
                              lecture(), terms)) {}

  std::array<int, 3> at(int column, int row) const {
    const auto i = 3 * static_cast<std::size_t>(row * 600 + column);
    return {bytes[i], bytes[i + 1], bytes[i + 2]};
  }

  std::vector<std::uint8_t> bytes;
};

using Rgb = std::array<int, 3>;

/// FNV-1a, 64 bits.
std::uint64_t digest(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001B3U;
  return hash;
}

}  // namespace

TEST_CASE("how many pixels each sphere has") {
  std::array<long, 5> counts{};
  for (const StoredPixel& pixel : lecture().pixels) {
    ++counts.at(static_cast<std::size_t>(pixel.sphere));
  }
  CHECK(counts == std::array<long, 5>{145929, 100029, 36100, 36407, 41535});
}

TEST_CASE("named pixels") {
  const Bytes all(combined);
  CHECK(all.at(300, 300) == Rgb{137, 0, 0});
  CHECK(all.at(100, 300) == Rgb{0, 195, 0});
  CHECK(all.at(480, 250) == Rgb{0, 0, 75});
  CHECK(all.at(50, 500) == Rgb{150, 150, 0});
  CHECK(all.at(0, 0) == Rgb{255, 255, 255});
  CHECK(Bytes(flat).at(300, 300) == Rgb{255, 0, 0});
  CHECK(Bytes(ambient).at(50, 500) == Rgb{51, 51, 0});
}

// Of the pictures whose SHA-256 begins 3667ef520646ece9, ac2d3e87d2811dae, 1844a6677a2a1525,
// f4c53146dceb4b16 and bfbc1d5931f651a9.
TEST_CASE("whole pictures") {
  CHECK(digest(Bytes(flat).bytes) == 0x415E35E3AA393F18);
  CHECK(digest(Bytes(ambient).bytes) == 0xEBA7BA47D5C90530);
  CHECK(digest(Bytes(point).bytes) == 0x28FFE8B77957BE55);
  CHECK(digest(Bytes(directional).bytes) == 0x104640468BA212E9);
  CHECK(digest(Bytes(combined).bytes) == 0x07FF5630EEB5F062);
}

TEST_CASE("where several spheres are right") {
  const auto& [at_float, at_double] = lecture().ambiguous;
  CHECK(at_float.size() == 252);
  // The tangent rays to the red sphere, but for the two where the floor is nearer.
  REQUIRE(at_double.size() == 3);
  CHECK(at_double[0].pixel == 299 * 600 + 300);
  CHECK(at_double[1].pixel == 449 * 600 + 100);
  CHECK(at_double[2].pixel == 449 * 600 + 500);
  for (const AmbiguousPixel& pixel : at_double) {
    CHECK(lecture().pixels[static_cast<std::size_t>(pixel.pixel)].sphere == 1);
    CHECK(pixel.alternatives.size() == 1);
  }
  CHECK(lecture().pixels[599 * 600 + 100].sphere == 4);
  CHECK(lecture().pixels[599 * 600 + 500].sphere == 4);
  const auto is_judged = [](const AmbiguousPixel& pixel) { return pixel.judged; };
  CHECK(std::all_of(at_float.begin(), at_float.end(), is_judged));
  CHECK(std::all_of(at_double.begin(), at_double.end(), is_judged));
}
