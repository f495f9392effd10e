#include "fos/frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fos/byte_rule.hpp"
#include "fos/scene_text.hpp"

namespace fos {
namespace {

constexpr std::array<char, 8> magic{'F', 'O', 'S', 'F', 'R', 'A', 'M', 'E'};

std::size_t real_size(Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return sizeof(float);
    case Precision::binary64:
      return sizeof(double);
    case Precision::extended:
      return sizeof(long double);
  }
  return 0;
}

template <typename T>
void decode_channels(std::span<const char> bytes, std::vector<long double>& channels) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    T channel;
    std::memcpy(&channel, bytes.data() + i * sizeof(T), sizeof(T));
    channels[i] = channel;
  }
}

}  // namespace

void Frame::append(const Row& row) {
  channels.insert(channels.end(), row.channels.begin(), row.channels.end());
  unwritten.insert(unwritten.end(), row.unwritten.begin(), row.unwritten.end());
}

std::span<const long double, 3> Frame::pixel(int column, int row) const {
  const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(header.width) +
                     static_cast<std::size_t>(column);
  return std::span<const long double, 3>(channels.data() + 3 * index, 3);
}

bool Frame::is_unwritten(int column, int row) const {
  return unwritten[static_cast<std::size_t>(row) * static_cast<std::size_t>(header.width) +
                   static_cast<std::size_t>(column)] != 0;
}

std::array<char, encoded_header_size> encode(const FrameHeader& header) {
  const std::array<std::uint32_t, 4> fields{static_cast<std::uint32_t>(header.width),
                                            static_cast<std::uint32_t>(header.height),
                                            static_cast<std::uint32_t>(header.precision), 0};
  std::array<char, encoded_header_size> bytes{};
  std::copy(magic.begin(), magic.end(), bytes.begin());
  std::memcpy(bytes.data() + magic.size(), fields.data(), sizeof(fields));
  return bytes;
}

std::optional<FrameHeader> decode_header(std::span<const char, encoded_header_size> bytes) {
  std::array<std::uint32_t, 4> fields{};
  std::memcpy(fields.data(), bytes.data() + magic.size(), sizeof(fields));
  const auto size_fits = [](std::uint32_t size) { return size >= 1 && size <= max_canvas; };
  const bool valid = std::equal(magic.begin(), magic.end(), bytes.begin()) &&
                     size_fits(fields[0]) && size_fits(fields[1]) &&
                     fields[2] <= static_cast<std::uint32_t>(Precision::extended);
  if (!valid) return std::nullopt;
  return FrameHeader{static_cast<int>(fields[0]), static_cast<int>(fields[1]),
                     static_cast<Precision>(fields[2])};
}

std::size_t encoded_row_size(const FrameHeader& header) {
  return static_cast<std::size_t>(header.width) * (3 * real_size(header.precision) + 1);
}

Row decode_row(const FrameHeader& header, std::span<const char> bytes) {
  const auto width = static_cast<std::size_t>(header.width);
  Row row{std::vector<long double>(3 * width), std::vector<std::uint8_t>(width)};
  switch (header.precision) {
    case Precision::binary32:
      decode_channels<float>(bytes, row.channels);
      break;
    case Precision::binary64:
      decode_channels<double>(bytes, row.channels);
      break;
    case Precision::extended:
      decode_channels<long double>(bytes, row.channels);
      break;
  }
  const std::span<const char> flags = bytes.last(width);
  std::transform(flags.begin(), flags.end(), row.unwritten.begin(),
                 [](char flag) { return static_cast<std::uint8_t>(flag != 0); });
  return row;
}

std::uint8_t to_byte(long double channel) { return nearest_byte(channel); }

bool is_finite(std::span<const long double, 3> pixel) {
  return std::all_of(pixel.begin(), pixel.end(), [](long double c) { return std::isfinite(c); });
}

std::array<long double, 3> shown(std::span<const long double, 3> pixel, bool unwritten, int column,
                                 int row) {
  if (unwritten) {
    const bool light = (column / 12 + row / 12) % 2 == 0;
    const long double grey = light ? 208 : 176;
    return {grey, grey, grey};
  }
  if (!is_finite(pixel)) {
    return {not_finite_color[0], not_finite_color[1], not_finite_color[2]};
  }
  return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace fos
