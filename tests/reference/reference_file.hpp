// Certified reference data of one scene: what every pixel is, and what a program may answer there.
//
// One file serves all stages of a scene, because it keeps the terms of I apart:
//   I = I_A + point + directional,  color = sphere's color * I
// The background's color is not multiplied by I. I_A and the colors are in the scene's text, which
// the file carries. docs/en/reference-data.md describes the format, how the accepted answers are
// derived, and the margin.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace fos::reference {

/// The precision of a program, by the bits of its significand.
enum class Precision { float24, double53 };
inline constexpr std::array<Precision, 2> precisions{Precision::float24, Precision::double53};

/// Widths are those of the slides' formula; a right program that goes another way may be off by
/// this many of them.
inline constexpr double margin = 2;

/// The canvas of a reference has at most this many pixels.
inline constexpr int max_pixels = 1 << 20;

/// One right answer at a pixel. A program of the asked precision that gives this answer has a point
/// term within margin * point_width of `point`; the same for the directional term. A width of 0
/// means that no light of that kind reaches the point: the term is 0 in every right program.
struct Answer {
  int sphere = 0;          ///< 0 is the background, else the sphere's number in the file, from 1
  double point = 0;        ///< sum over the point lights, >= 0
  double directional = 0;  ///< sum over the directional lights, >= 0
  double point_width = 0;
  double directional_width = 0;
};

/// All right answers at a pixel.
struct Accepted {
  bool judged = true;  ///< false: at this precision the formula says nothing here; accept anything
  Answer certified;    ///< the exact answer, always right
  std::vector<Answer> alternatives;  ///< what rounding may make of it; empty for nearly all pixels
};

/// How far a term may be from the stored one: code 0 is 0, code w > 0 is 2^(step + w - 1).
struct WidthCodes {
  std::uint8_t point = 0;
  std::uint8_t directional = 0;

  friend bool operator==(const WidthCodes&, const WidthCodes&) = default;
};

/// The certified answer as the file has it: terms are whole multiples of 2^step, and the exact term
/// is within 2^(step - 1) of the stored one.
struct StoredPixel {
  std::int32_t sphere = 0;
  std::int64_t point = 0;
  std::int64_t directional = 0;
  std::array<WidthCodes, precisions.size()> widths;  ///< by Precision

  friend bool operator==(const StoredPixel&, const StoredPixel&) = default;
};

struct StoredAlternative {
  std::int32_t sphere = 0;
  std::int64_t point = 0;
  std::int64_t directional = 0;
  WidthCodes widths;

  friend bool operator==(const StoredAlternative&, const StoredAlternative&) = default;
};

/// A pixel where a precision accepts more than the certified answer.
struct AmbiguousPixel {
  std::int32_t pixel = 0;  ///< row * width + column
  bool judged = true;      ///< if false there are no alternatives
  std::vector<StoredAlternative> alternatives;

  friend bool operator==(const AmbiguousPixel&, const AmbiguousPixel&) = default;
};

/// The contents of one file.
struct Reference {
  std::string scene_text;  ///< the scene file, byte for byte
  int width = 0;
  int height = 0;
  int step = 0;                     ///< exponent: terms are multiples of 2^step
  std::vector<StoredPixel> pixels;  ///< width * height, rows from the top
  std::array<std::vector<AmbiguousPixel>, precisions.size()> ambiguous;  ///< by pixel, rising

  /// What is right at a pixel for a program of `precision`; column 0 is left, row 0 is the top.
  Accepted accepted(int column, int row, Precision precision) const;

  friend bool operator==(const Reference&, const Reference&) = default;
};

/// A file that is not a whole, undamaged reference, or that cannot be read or written.
class ReferenceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of a file, and back. `decode` takes any bytes: it throws ReferenceError, whatever they
/// are, and takes no more memory than max_pixels need.
std::string encode(const Reference& reference);
Reference decode(std::span<const char> bytes);

/// Throws ReferenceError with the path in its message.
Reference read_reference(const std::filesystem::path& path);

/// Writes a temporary file beside `path`, then renames it, so that `path` is whole at any time.
/// Throws ReferenceError.
void write_reference(const std::filesystem::path& path, const Reference& reference);

}  // namespace fos::reference
