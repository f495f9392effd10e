#include "fos/frame.hpp"

#include <cstring>
#include <limits>

#include "catch2.hpp"

using namespace fos;

TEST_CASE("the byte rule: round half to even of the channel, cut off at 0 and 255") {
  const std::pair<long double, int> cases[] = {
      {0, 0},        {0.5L, 0},     {1.5L, 2},       {2.5L, 2},       {127.5L, 128},
      {128.5L, 128}, {254.5L, 254}, {0.4999L, 0},    {136.501L, 137}, {171.9L, 172},
      {51, 51},      {255, 255},    {255.4L, 255},   {1e30L, 255},    {-0.4L, 0},
      {-7, 0},       {-1e30L, 0},   {0.5000001L, 1}, {1.4999999L, 1}};
  for (const auto& [channel, byte] : cases) {
    INFO(static_cast<double>(channel));
    CHECK(to_byte(channel) == byte);
  }
  // Ties are exact: the numbers next to one go their own way.
  const double tie = 3.5;
  CHECK(to_byte(std::nextafter(tie, 0.0)) == 3);
  CHECK(to_byte(std::nextafter(tie, 9.0)) == 4);
  CHECK(to_byte(std::nextafter(2.5, 9.0)) == 3);
  CHECK(to_byte(std::numeric_limits<long double>::infinity()) == 255);
}

TEST_CASE("what is not finite is never passed off as a color") {
  const long double nan = std::numeric_limits<long double>::quiet_NaN();
  const long double infinity = std::numeric_limits<long double>::infinity();
  for (const std::array<long double, 3>& pixel :
       {std::array{nan, 1.0L, 1.0L}, std::array{1.0L, -infinity, 1.0L},
        std::array{1.0L, 1.0L, infinity}}) {
    CHECK_FALSE(is_finite(pixel));
    CHECK(shown(pixel, false, 0, 0) == std::array<long double, 3>{255, 0, 255});
  }
  CHECK(is_finite(std::array{1e30L, -5.0L, 0.0L}));
}

TEST_CASE("an unwritten pixel shows as a checkerboard, whatever its channels") {
  const std::array<long double, 3> red{255, 0, 0};
  const auto light = shown(red, true, 0, 0);
  const auto dark = shown(red, true, 12, 0);
  CHECK(light != dark);
  CHECK(shown(red, true, 12, 12) == light);
  CHECK(shown(red, true, 11, 11) == light);
  CHECK(shown(red, false, 0, 0) == red);
}

TEST_CASE("a header travels and comes back, and garbage does not") {
  const FrameHeader header{600, 16384, Precision::extended};
  auto bytes = encode(header);
  const auto back = decode_header(bytes);
  REQUIRE(back);
  CHECK(back->width == 600);
  CHECK(back->height == 16384);
  CHECK(back->precision == Precision::extended);

  const auto refused_with = [&](std::size_t at, char value) {
    auto damaged = bytes;
    damaged[at] = value;
    return !decode_header(damaged);
  };
  CHECK(refused_with(0, 'X'));      // magic
  CHECK(refused_with(11, '\x7F'));  // a width of two thousand millions
  CHECK(refused_with(16, '\x03'));  // no such precision
  CHECK_FALSE(decode_header(encode({0, 1, Precision::binary64})));
  CHECK_FALSE(decode_header(encode({16385, 1, Precision::binary64})));
}

namespace {

template <typename T>
Row row_of(Precision precision, const std::vector<T>& channels,
           const std::vector<std::uint8_t>& unwritten) {
  std::vector<char> bytes(channels.size() * sizeof(T) + unwritten.size());
  std::memcpy(bytes.data(), channels.data(), channels.size() * sizeof(T));
  std::memcpy(bytes.data() + channels.size() * sizeof(T), unwritten.data(), unwritten.size());
  const FrameHeader header{static_cast<int>(unwritten.size()), 1, precision};
  REQUIRE(encoded_row_size(header) == bytes.size());
  return decode_row(header, bytes);
}

}  // namespace

TEST_CASE("a row travels without losing a digit, at each precision") {
  const Row f = row_of<float>(Precision::binary32, {0.1F, 1e30F, -0.0F, 1, 2, 3}, {0, 1});
  CHECK(f.channels[0] == 0.1F);
  CHECK(f.channels[1] == 1e30F);
  CHECK(f.unwritten == std::vector<std::uint8_t>{0, 1});
  const Row d = row_of<double>(Precision::binary64, {0.1, 1e300, 255}, {7});
  CHECK(d.channels[0] == 0.1);
  CHECK(d.channels[1] == 1e300);
  CHECK(d.unwritten == std::vector<std::uint8_t>{1});
  const Row e = row_of<long double>(Precision::extended, {0.1L, 1e4000L, 255}, {0});
  CHECK(e.channels[0] == 0.1L);
}
