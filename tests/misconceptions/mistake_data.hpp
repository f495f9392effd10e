// What each mistake, and each pair of mistakes, gives on the diagnostic scenes: one file a stage.
//
// A file begins with the line `fos mistakes 2 SCENES CATALOGUE BYTES`: the checksums of the scenes
// and of the catalogue that it was made with, and the size of what follows once it is inflated
// (zlib). That is, numbers in two bytes each, the low one first:
//   the sphere that each pixel sees, scene after scene, row by row: its number in the file, 0 for
//   the background
//   how many planes there are, and for each
//     its two mistakes, 0xffff where there are none
//     how many of its pixels are not compared, and which
//     its guide (plane_guide.hpp): a plane, 0xffff for none; and a byte, 1 if it is corrected
//     its symbols: of every pixel the sphere that is seen, in a stage without light; else of every
//     pixel that sees a sphere the code of its I (light_code.hpp)
//   then, for every light that the stage counts, the plane of its term alone, in which 0 is a pixel
//   that it does not reach; and for each of them the plane of |L| / 4
// Of a symbol its difference from the guide is taken, and of that what it differs from what its
// neighbours suggest: in one byte, or after the byte 0xff in two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fos/scene_text.hpp"
#include "fos/stage_list.hpp"
#include "mistakes.hpp"

namespace fos {

/// The symbols of all pixels of the scenes, one after the other: light codes or spheres.
using Symbols = std::vector<std::uint16_t>;

/// In the plane of a light term, a pixel that the light does not reach: not the code of any I.
inline constexpr std::uint16_t light_is_behind = 0;

struct Plane {
  std::optional<Mistake> first;
  std::optional<Mistake> second;
  std::vector<std::uint16_t> not_compared;  ///< pixels whose answer hangs on rounding
  Symbols symbols;                          ///< those that hold no light are 0
};

/// The planes of a stage. The first is the right one; then come the mistakes, then the pairs.
struct StageMistakes {
  bool has_light = false;              ///< whether symbols are light codes, or spheres
  std::vector<std::uint16_t> spheres;  ///< that the right tracer sees
  std::vector<Plane> planes;
  std::vector<Symbols> terms;      ///< each light alone, in the order of term_scenes()
  std::vector<Symbols> distances;  ///< |L| / 4 of the same lights, 0 for a directional one
};

/// Thrown for data that are missing, damaged, or of other scenes or another catalogue.
class MistakeDataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string encode(const StageMistakes& mistakes, const std::vector<SceneText>& scenes);

/// Throws MistakeDataError.
StageMistakes decode(const std::string& file, const std::vector<SceneText>& scenes);

/// Reads the file of a stage. Throws MistakeDataError.
StageMistakes read_mistakes(const std::filesystem::path& path,
                            const std::vector<SceneText>& scenes);

/// The data of a stage, read once and kept. Throws MistakeDataError.
const StageMistakes& mistakes_of(const Stage& stage);

}  // namespace fos
