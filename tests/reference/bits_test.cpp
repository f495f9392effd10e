#include "bits.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "catch2.hpp"
#include "term_coder.hpp"

using namespace fos::reference;

namespace {

/// Codes the numbers with one Coder and decodes them with another.
template <class Coder, class Number>
std::vector<Number> there_and_back(std::vector<Number> numbers) {
  BitWriter writer;
  Coder write_coder;
  for (Number& number : numbers) write_coder.code(writer, number);
  const std::string bytes = writer.take();
  BitReader reader(bytes);
  Coder read_coder;
  std::vector<Number> result(numbers.size());
  for (Number& number : result) read_coder.code(reader, number);
  CHECK(reader.is_at_end());
  return result;
}

constexpr std::int64_t max_int = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t min_int = std::numeric_limits<std::int64_t>::min();

}  // namespace

TEST_CASE("bits come back, the highest first") {
  BitWriter writer;
  std::uint64_t three_bits = 5;
  std::uint64_t all_bits = 0x8000000000000001;
  writer.bits(three_bits, 3);
  writer.bits(all_bits, 64);
  const std::string bytes = writer.take();
  REQUIRE(bytes.size() == 9);
  CHECK(static_cast<unsigned char>(bytes[0]) == 0xB0);  // 101 10000
  BitReader reader(bytes);
  std::uint64_t value = 0;
  reader.bits(value, 3);
  CHECK(value == 5);
  reader.bits(value, 64);
  CHECK(value == all_bits);
  CHECK(reader.is_at_end());
  CHECK_THROWS_AS(reader.bits(value, 6), ReferenceError);
}

TEST_CASE("Golomb-Rice codes of any number with any k") {
  for (const int k : {0, 1, 7, 40, 56}) {
    for (const std::uint64_t n : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{23},
                                  std::uint64_t{24}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
      BitWriter writer;
      std::uint64_t written = n;
      code_rice(writer, written, k);
      const std::string bytes = writer.take();
      BitReader reader(bytes);
      std::uint64_t read = 0;
      code_rice(reader, read, k);
      CHECK(read == n);
    }
  }
}

TEST_CASE("zigzag puts small numbers first") {
  CHECK(zigzag(0) == 0);
  CHECK(zigzag(-1) == 1);
  CHECK(zigzag(1) == 2);
  for (const std::int64_t n : {max_int, min_int, std::int64_t{-77}}) {
    CHECK(unzigzag(zigzag(n)) == n);
  }
}

TEST_CASE("numbers and terms come back, jumps and extremes too") {
  std::vector<std::int64_t> numbers{0, 1, -1, max_int, min_int, min_int, 5, max_int, 0};
  for (int i = 0; i < 100; ++i) numbers.push_back(i * i * i - 50 * i);
  CHECK(there_and_back<NumberCoder>(numbers) == numbers);
  CHECK(there_and_back<TermCoder>(numbers) == numbers);
}

TEST_CASE("a smooth row of terms takes few bits") {
  BitWriter writer;
  TermCoder coder;
  constexpr int count = 200;
  for (int i = 0; i < count; ++i) {
    const double x = (i - 100) / 120.0;
    auto term = static_cast<std::int64_t>(std::ldexp(std::sqrt(1 - x * x), 40));
    coder.code(writer, term);
  }
  CHECK(writer.take().size() < std::size_t{2} * count);
}
