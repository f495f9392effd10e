#include "reference_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "reference_codec.hpp"

namespace fos::reference {
namespace {

constexpr std::string_view magic = "fos-reference 1\n";
constexpr std::size_t checksum_size = 4;
constexpr std::size_t max_scene_size = 1 << 20;
constexpr std::uintmax_t max_file_size = 1 << 28;
constexpr int max_step = 1000;

/// CRC-32 as in PNG and zip: polynomial 0xEDB88320, reflected, all ones at both ends.
std::uint32_t checksum(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      std::uint32_t entry = i;
      for (int bit = 0; bit < 8; ++bit) entry = (entry >> 1) ^ (entry & 1 ? 0xEDB88320U : 0);
      entries[i] = entry;
    }
    return entries;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes)
    crc = (crc >> 8) ^ table[(crc ^ static_cast<unsigned char>(byte)) & 0xFF];
  return ~crc;
}

/// The checksum as it stands in the file: four bytes, the lowest first.
std::string checksum_bytes(std::string_view bytes) {
  const std::uint32_t crc = checksum(bytes);
  std::string result;
  for (int shift = 0; shift < 32; shift += 8) result.push_back(static_cast<char>(crc >> shift));
  return result;
}

/// Takes header lines off the front of `rest`.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view rest) : rest_(rest) {}

  void skip(std::string_view expected) {
    if (!rest_.starts_with(expected)) throw ReferenceError("has a damaged header");
    rest_.remove_prefix(expected.size());
  }

  /// A whole number in [low, high].
  int number(int low, int high) {
    int value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc() || value < low || value > high) {
      throw ReferenceError("has a number out of range in its header");
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  std::string_view bytes(std::size_t count) {
    if (count > rest_.size()) throw ReferenceError("ends too early");
    const std::string_view result = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return result;
  }

  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

double to_width(std::uint8_t code, int step) {
  return code == 0 ? 0 : std::ldexp(1.0, step + code - 1);
}

/// For a StoredPixel or a StoredAlternative.
template <class Stored>
Answer to_answer(const Stored& stored, WidthCodes widths, int step) {
  return {stored.sphere, std::ldexp(static_cast<double>(stored.point), step),
          std::ldexp(static_cast<double>(stored.directional), step), to_width(widths.point, step),
          to_width(widths.directional, step)};
}

}  // namespace

Accepted Reference::accepted(int column, int row, Precision precision) const {
  const std::int32_t pixel = row * width + column;
  const auto i = static_cast<std::size_t>(precision);
  const StoredPixel& stored = pixels[static_cast<std::size_t>(pixel)];
  Accepted accepted{true, to_answer(stored, stored.widths[i], step), {}};
  const std::vector<AmbiguousPixel>& list = ambiguous[i];
  const auto found = std::lower_bound(
      list.begin(), list.end(), pixel,
      [](const AmbiguousPixel& entry, std::int32_t wanted) { return entry.pixel < wanted; });
  if (found == list.end() || found->pixel != pixel) return accepted;
  accepted.judged = found->judged;
  for (const StoredAlternative& alternative : found->alternatives) {
    accepted.alternatives.push_back(to_answer(alternative, alternative.widths, step));
  }
  return accepted;
}

std::string encode(const Reference& reference) {
  std::ostringstream header;
  header << magic << "canvas " << reference.width << ' ' << reference.height << "\nstep "
         << reference.step << "\nscene " << reference.scene_text.size() << '\n';
  std::string bytes = header.str() + reference.scene_text + encode_body(reference);
  bytes += checksum_bytes(bytes);
  return bytes;
}

Reference decode(std::span<const char> bytes) {
  const std::string_view all(bytes.data(), bytes.size());
  if (!all.starts_with(magic)) throw ReferenceError("is not a reference of format 1");
  if (all.size() < magic.size() + checksum_size) throw ReferenceError("ends too early");
  const std::string_view checked = all.substr(0, all.size() - checksum_size);
  if (checksum_bytes(checked) != all.substr(checked.size())) {
    throw ReferenceError("is damaged: its checksum is wrong");
  }
  Reference reference;
  HeaderReader header(checked);
  header.skip(magic);
  header.skip("canvas ");
  reference.width = header.number(1, max_pixels);
  header.skip(" ");
  reference.height = header.number(1, max_pixels / reference.width);
  header.skip("\nstep ");
  reference.step = header.number(-max_step, max_step);
  header.skip("\nscene ");
  const int scene_size = header.number(0, max_scene_size);
  header.skip("\n");
  reference.scene_text = header.bytes(static_cast<std::size_t>(scene_size));
  decode_body(header.rest(), reference);
  return reference;
}

Reference read_reference(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > max_file_size) throw ReferenceError(path.string() + ": cannot be read");
  std::string bytes(size, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    throw ReferenceError(path.string() + ": cannot be read");
  }
  try {
    return decode(bytes);
  } catch (const ReferenceError& damage) {
    throw ReferenceError(path.string() + ": " + damage.what());
  }
}

void write_reference(const std::filesystem::path& path, const Reference& reference) {
  const std::string bytes = encode(reference);
  std::filesystem::path temporary = path;
  temporary += ".part";
  std::ofstream file(temporary, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(temporary, path, error);
  if (!file || error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw ReferenceError(path.string() + ": cannot be written");
  }
}

}  // namespace fos::reference
