#include "reference_file.hpp"

#include <fstream>
#include <random>

#include "catch2.hpp"

using namespace fos::reference;

namespace {

/// A small reference with something of everything.
Reference sample() {
  Reference reference{std::string("a scene\nwith \0 bytes", 20), 7, 5, -40, {}, {}};
  for (int i = 0; i < 35; ++i) {
    StoredPixel pixel;
    if (i % 7 > 1) {
      pixel = {1 + i / 20, std::int64_t{1000000} * i * i + 1, i % 3 == 0 ? 0 : 77777 + i, {}};
      pixel.widths = {WidthCodes{static_cast<std::uint8_t>(20 + i / 9), 19}, WidthCodes{1, 0}};
    }
    reference.pixels.push_back(pixel);
  }
  reference.ambiguous[0] = {{3, true, {{2, 123456789, 0, {9, 0}}, {0, 0, 0, {}}}},
                            {4, false, {}},
                            {34, true, {{1, 1, std::int64_t{1} << 45, {255, 1}}}}};
  reference.ambiguous[1] = {{0, true, {{3, 0, 0, {}}}}};
  return reference;
}

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) * 0xEDB88320U);
  }
  return ~crc;
}

/// `bytes` with the checksum that fits them, for damage that a checksum does not show.
std::string sealed(std::string bytes) {
  const std::uint32_t crc = crc32(bytes);
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(crc >> shift));
  return bytes;
}

std::string without_checksum(const Reference& reference) {
  std::string bytes = encode(reference);
  bytes.resize(bytes.size() - 4);
  return bytes;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// A folder that is gone afterwards.
struct TemporaryFolder {
  TemporaryFolder() : path(std::filesystem::temp_directory_path() / name()) {
    std::filesystem::create_directory(path);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  static std::string name() { return "fos-reference-" + std::to_string(std::random_device{}()); }

  std::filesystem::path path;
};

}  // namespace

TEST_CASE("what is decoded is what was encoded") {
  const Reference reference = sample();
  CHECK(decode(encode(reference)) == reference);
}

TEST_CASE("the answers at a pixel, in plain numbers") {
  const Reference reference = sample();
  const Accepted several = reference.accepted(3, 0, Precision::float24);
  CHECK(several.judged);
  CHECK(several.certified.sphere == 1);
  CHECK(several.certified.point == std::ldexp(9000001.0, -40));
  CHECK(several.certified.point_width == std::ldexp(1.0, -40 + 20 - 1));
  REQUIRE(several.alternatives.size() == 2);
  CHECK(several.alternatives[0].sphere == 2);
  CHECK(several.alternatives[0].directional_width == 0);
  CHECK(several.alternatives[1].sphere == 0);
  CHECK_FALSE(reference.accepted(4, 0, Precision::float24).judged);
  const Accepted one = reference.accepted(4, 0, Precision::double53);
  CHECK(one.judged);
  CHECK(one.alternatives.empty());
  CHECK(one.certified.directional_width == 0);
}

TEST_CASE("a file that ends early or has a wrong byte is refused") {
  const std::string bytes = encode(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_THROWS_AS(decode(std::span(bytes).first(size)), ReferenceError);
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    CHECK_THROWS_AS(decode(damaged), ReferenceError);
  }
  CHECK_THROWS_AS(decode(bytes + '\0'), ReferenceError);
}

TEST_CASE("damage behind a right checksum is refused too") {
  const std::string bytes = without_checksum(sample());
  REQUIRE_NOTHROW(decode(sealed(bytes)));
  CHECK_THROWS_AS(decode(sealed(bytes + '\0')), ReferenceError);
  CHECK_THROWS_AS(decode(sealed(bytes.substr(0, bytes.size() - 1))), ReferenceError);
  CHECK_THROWS_AS(decode(sealed(replaced(bytes, "nce 1", "nce 2"))), ReferenceError);
  for (const char* canvas : {"canvas 0 5", "canvas -7 5", "canvas 7 5x", "canvas 99999999999 5",
                             "canvas 65536 65536", "canvas 7 6", "canvas"}) {
    CHECK_THROWS_AS(decode(sealed(replaced(bytes, "canvas 7 5", canvas))), ReferenceError);
  }
  CHECK_THROWS_AS(decode(sealed(replaced(bytes, "step -40", "step 5000"))), ReferenceError);
  CHECK_THROWS_AS(decode(sealed(replaced(bytes, "scene ", "scene 9999"))), ReferenceError);
}

TEST_CASE("garbage is refused or read, and harms nobody") {
  std::mt19937 random(1);
  const std::string bytes = without_checksum(sample());
  const std::size_t header_size = bytes.find("with") + 4;
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = bytes;
    for (int j = 0; j < 3; ++j) {
      damaged[header_size + random() % (bytes.size() - header_size)] = static_cast<char>(random());
    }
    try {
      const Reference read = decode(sealed(damaged));
      CHECK(read.pixels.size() == 35);
    } catch (const ReferenceError&) {
      ++refused;
    }
  }
  CHECK(refused > 0);
}

TEST_CASE("files") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path / "sample.ref";
  const Reference reference = sample();

  SECTION("are written whole and read again") {
    write_reference(path, reference);
    CHECK(read_reference(path) == reference);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
  }
  SECTION("that cannot be written leave nothing behind") {
    std::filesystem::create_directory(path);
    CHECK_THROWS_AS(write_reference(path, reference), ReferenceError);
    CHECK_THROWS_AS(write_reference(folder.path / "none" / "x.ref", reference), ReferenceError);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
  }
  SECTION("that cannot be read are named") {
    CHECK_THROWS_WITH(read_reference(path), ContainsSubstring("sample.ref: cannot be read"));
    CHECK_THROWS_AS(read_reference(folder.path), ReferenceError);
    std::ofstream(path) << "no reference";
    CHECK_THROWS_WITH(read_reference(path), ContainsSubstring("not a reference of format 1"));
  }
}
