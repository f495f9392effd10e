// A frame: what a stage program answers with, how it travels, and how its numbers become bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fos {

/// The Real of a program: float, double, long double.
enum class Precision : std::uint32_t { binary32, binary64, extended };

struct FrameHeader {
  int width = 0;
  int height = 0;
  Precision precision = Precision::binary64;
};

/// One row of a frame, held in the widest type, so that no digit is lost whatever the precision.
struct Row {
  std::vector<long double> channels;    ///< 3 a pixel: red, green, blue, 0..255 and unclamped
  std::vector<std::uint8_t> unwritten;  ///< 1 a pixel: whether unwritten() was called for it
};

/// A whole frame in memory, rows from the top.
struct Frame {
  FrameHeader header;
  std::vector<long double> channels;
  std::vector<std::uint8_t> unwritten;

  void append(const Row& row);
  std::span<const long double, 3> pixel(int column, int row) const;
  bool is_unwritten(int column, int row) const;
};

/// How a frame travels: the header, then each row as its channels in the program's own Real (the
/// machine's byte order) followed by a byte a pixel that is 1 where the pixel is unwritten.
constexpr std::size_t encoded_header_size = 24;
/// A header of 0 x 0 pixels says that the program cannot carry the scene, and has said why.
std::array<char, encoded_header_size> encode(const FrameHeader& header);
/// Nothing where the bytes are no header of a frame.
std::optional<FrameHeader> decode_header(std::span<const char, encoded_header_size> bytes);

/// Bytes a row takes, and the row that they write.
std::size_t encoded_row_size(const FrameHeader& header);
Row decode_row(const FrameHeader& header, std::span<const char> bytes);

/// THE byte rule: round half to even of clamp(channel, 0, 255). `channel` is not NaN.
std::uint8_t to_byte(long double channel);

/// Whether every channel is finite. One that is not is never passed off as a color.
bool is_finite(std::span<const long double, 3> pixel);

/// The color to show for a pixel: its own, magenta where it is not finite, a checkerboard of greys
/// where it is unwritten.
std::array<long double, 3> shown(std::span<const long double, 3> pixel, bool unwritten, int column,
                                 int row);

}  // namespace fos
