// A scene file as it was written: every number an exact decimal, with its place in the file.
//
// Reading a scene has two steps. This is the first, text -> SceneText: grammar, keys, and the
// ranges that hold for every precision. The second, scene_file.hpp, makes the numbers Reals. The
// reference tracer takes this first step only, so that it shares no rounding with what it judges.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fos {

/// A place in a text file: line and column from 1, columns in characters (not bytes).
struct Place {
  int line = 1;
  int column = 1;
};

/// An exact decimal: value = (negative ? -1 : 1) * digits * 10^exponent.
/// `digits` has neither leading nor trailing zeros; zero is the empty string, not negative.
struct Decimal {
  bool negative = false;
  std::string digits;
  long exponent = 0;
  std::string text = "0";  ///< as written in the file
  Place place;             ///< of its first character

  bool is_zero() const { return digits.empty(); }
};

/// -1, 0 or 1 as a < b, a == b or a > b: exact, whatever the sizes.
int compare(const Decimal& a, const Decimal& b);

/// The decimal that `text` writes: optional sign, digits with an optional point (`.5` and `5.`
/// too), optional exponent. Throws std::invalid_argument for anything else.
Decimal parse_decimal(std::string_view text);

using DecimalTriple = std::array<Decimal, 3>;

struct SphereText {
  DecimalTriple center;
  Decimal radius;       ///< > 0
  DecimalTriple color;  ///< each 0..255
};

enum class LightKind { ambient, point, directional };

struct LightText {
  LightKind kind = LightKind::ambient;
  Decimal intensity;  ///< >= 0
  DecimalTriple
      vector;   ///< point: the position; directional: the direction toward the light, not 0
  Place place;  ///< of the word `light`
};

/// One scene file. The member initialisers are the defaults of the header lines.
struct SceneText {
  std::string name;    ///< what the file is called in messages
  std::string source;  ///< the whole file
  int canvas_width = 600;
  int canvas_height = 600;
  std::array<Decimal, 2> viewport_size{parse_decimal("1"), parse_decimal("1")};  ///< > 0
  Decimal projection_plane_d = parse_decimal("1");                               ///< > 0
  DecimalTriple camera_position{parse_decimal("0"), parse_decimal("0"), parse_decimal("0")};
  DecimalTriple background_color{parse_decimal("255"), parse_decimal("255"), parse_decimal("255")};
  std::vector<SphereText> spheres;
  std::vector<LightText> lights;  ///< in the order of the file; at most one is ambient
};

/// The canvas is 1..max_canvas pixels in each direction; a file has at most max_scene_bytes.
inline constexpr int max_canvas = 16384;
inline constexpr std::size_t max_scene_bytes = 1 << 20;

/// What is wrong with a scene, ready to print: `FILE:LINE:COLUMN: error: …`, the line, a caret.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of a scene file. Throws SceneError.
SceneText parse_scene_text(std::string_view source, std::string name);

/// Reads a scene file. Throws SceneError, also where there is no such file or it cannot be read.
SceneText read_scene_text(const std::filesystem::path& path);

/// What is valid but probably not meant (no spheres, no lights), ready to print, in order.
std::vector<std::string> scene_warnings(const SceneText& scene);

/// The error at `place` of `scene`'s source, for steps that find something wrong later on.
SceneError scene_error(std::string_view source, std::string_view name, Place place,
                       std::string_view message);

}  // namespace fos
