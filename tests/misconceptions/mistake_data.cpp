#include "mistake_data.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <bit>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>

#include "diagnostic_scenes.hpp"
#include "plane_guide.hpp"
#include "symbol_layout.hpp"

namespace fos {
namespace {

constexpr std::uint16_t none = 0xffff;
constexpr unsigned char escape = 0xff;

unsigned long checksum(unsigned long sum, std::string_view bytes) {
  return crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
}

unsigned long scenes_checksum(const std::vector<SceneText>& scenes) {
  unsigned long sum = 0;
  for (const SceneText& scene : scenes) sum = checksum(sum, scene.source);
  return sum;
}

unsigned long catalogue_checksum() {
  unsigned long sum = 0;
  for (const Misconception& each : misconceptions()) {
    sum =
        checksum(sum, fmt::format("{} {} {};", each.id, static_cast<int>(each.slot), each.stages));
  }
  return sum;
}

void put(std::string& bytes, std::size_t number) {
  bytes.push_back(static_cast<char>(number & 0xff));
  bytes.push_back(static_cast<char>(number >> 8 & 0xff));
}

/// How far each symbol is from what its neighbours suggest, both less the guide; small numbers for
/// small differences of either sign.
std::vector<std::uint16_t> folded(const SymbolLayout& layout, const Symbols& symbols,
                                  const Symbols& guide) {
  std::vector<std::uint16_t> all;
  std::vector<int> beyond(layout.size());
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (!layout.has_symbol(i)) continue;
    beyond[i] = static_cast<std::int16_t>(symbols[i] - guide[i]);
    const auto off = static_cast<std::int16_t>(beyond[i] - layout.predict(beyond, i));
    all.push_back(static_cast<std::uint16_t>(off < 0 ? -2 * off - 1 : 2 * off));
  }
  return all;
}

void put(std::string& bytes, const std::vector<std::uint16_t>& all) {
  for (const std::uint16_t folded : all) {
    if (folded < escape) {
      bytes.push_back(static_cast<char>(folded));
    } else {
      bytes.push_back(static_cast<char>(escape));
      put(bytes, folded);
    }
  }
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  unsigned char byte() {
    if (next_ == bytes_.size()) throw MistakeDataError("the data of the mistakes end too soon");
    return static_cast<unsigned char>(bytes_[next_++]);
  }
  std::uint16_t number() {
    const unsigned low = byte();
    return static_cast<std::uint16_t>(low | static_cast<unsigned>(byte()) << 8);
  }
  Symbols symbols(const SymbolLayout& layout, const Symbols& guide) {
    Symbols symbols(layout.size());
    std::vector<int> beyond(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
      if (!layout.has_symbol(i)) continue;
      std::uint16_t folded = byte();
      if (folded == escape) folded = number();
      const int off = (folded & 1) != 0 ? -(folded + 1) / 2 : folded / 2;
      beyond[i] = static_cast<std::int16_t>(layout.predict(beyond, i) + off);
      symbols[i] = static_cast<std::uint16_t>(guide[i] + beyond[i]);
    }
    return symbols;
  }
  std::optional<Mistake> mistake() {
    const std::uint16_t which = number();
    if (which == none) return std::nullopt;
    return static_cast<Mistake>(which);
  }
  Guide guide() {
    Guide guide;
    const std::uint16_t plane = number();
    if (plane != none) guide.plane = plane;
    guide.corrected = byte() != 0;
    return guide;
  }
  bool at_end() const { return next_ == bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t next_ = 0;
};

/// About how much a plane takes, in sixteenths of a bit, or more than `most`. In whole numbers, so
/// that every machine chooses the same guides.
std::size_t size_of(const std::vector<std::uint16_t>& all, std::size_t most) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < all.size() && size <= most; ++i) {
    const std::size_t n = all[i] + 1U;
    const auto log = static_cast<std::size_t>(std::bit_width(n)) - 1;
    size += 16 * log + ((n << 4U >> log) - 16);  // log2, a straight line between powers of two
  }
  return size;
}

/// A plane with the guide that makes it smallest.
void put_guided(std::string& bytes, const SymbolLayout& layout, const PlaneGuides& guides,
                const Plane& plane) {
  std::vector<std::uint16_t> best;
  auto least = std::numeric_limits<std::size_t>::max();
  Guide which;
  for (const Guide& guide : guides.of(plane)) {
    auto made = folded(layout, plane.symbols, guides.make(guide, plane));
    const std::size_t size = size_of(made, least);
    if (size >= least) continue;
    best = std::move(made);
    least = size;
    which = guide;
  }
  put(bytes, which.plane.value_or(none));
  bytes.push_back(which.corrected ? 1 : 0);
  put(bytes, best);
}

std::size_t number_of(std::optional<Mistake> mistake) {
  return mistake ? static_cast<std::size_t>(*mistake) : none;
}

}  // namespace

std::string encode(const StageMistakes& mistakes, const std::vector<SceneText>& scenes) {
  std::string bytes;
  put(bytes, mistakes.has_light ? 1 : 0);
  const SymbolLayout everywhere(scenes, nullptr);
  const Symbols no_guide(everywhere.size());
  put(bytes, folded(everywhere, mistakes.spheres, no_guide));
  const SymbolLayout layout(scenes, mistakes.has_light ? &mistakes.spheres : nullptr);
  put(bytes, mistakes.planes.size());
  PlaneGuides guides(everywhere.size());
  for (const Plane& plane : mistakes.planes) {
    put(bytes, number_of(plane.first));
    put(bytes, number_of(plane.second));
    put(bytes, plane.not_compared.size());
    for (const std::uint16_t pixel : plane.not_compared) put(bytes, pixel);
    put_guided(bytes, layout, guides, plane);
    guides.add(plane);
  }
  put(bytes, mistakes.terms.size());
  for (const Symbols& term : mistakes.terms) put(bytes, folded(layout, term, no_guide));
  for (const Symbols& distance : mistakes.distances) {
    put(bytes, folded(layout, distance, no_guide));
  }

  std::string file = fmt::format("fos mistakes 2 {:08x} {:08x} {}\n", scenes_checksum(scenes),
                                 catalogue_checksum(), bytes.size());
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
            reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  return file.append(packed, 0, size);
}

StageMistakes decode(const std::string& file, const std::vector<SceneText>& scenes) {
  unsigned long of_scenes = 0;
  unsigned long of_catalogue = 0;
  uLongf size = 0;
  const std::size_t begin = file.find('\n') + 1;
  if (begin == 0 || std::sscanf(file.c_str(), "fos mistakes 2 %lx %lx %lu", &of_scenes,
                                &of_catalogue, &size) != 3) {
    throw MistakeDataError("these are no data of mistakes");
  }
  if (of_scenes != scenes_checksum(scenes) || of_catalogue != catalogue_checksum()) {
    throw MistakeDataError("these data are of other scenes or mistakes: build mistakes_data");
  }
  std::string bytes(size, '\0');
  const int status =
      uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                 reinterpret_cast<const Bytef*>(file.data() + begin), file.size() - begin);
  if (status != Z_OK || size != bytes.size()) {
    throw MistakeDataError("the data of the mistakes are damaged");
  }

  Reader in(bytes);
  StageMistakes mistakes;
  mistakes.has_light = in.number() != 0;
  const SymbolLayout everywhere(scenes, nullptr);
  const Symbols no_guide(everywhere.size());
  mistakes.spheres = in.symbols(everywhere, no_guide);
  const SymbolLayout layout(scenes, mistakes.has_light ? &mistakes.spheres : nullptr);
  mistakes.planes.resize(in.number());
  PlaneGuides guides(everywhere.size());
  for (Plane& plane : mistakes.planes) {
    plane.first = in.mistake();
    plane.second = in.mistake();
    plane.not_compared.resize(in.number());
    for (std::uint16_t& pixel : plane.not_compared) pixel = in.number();
    const Guide guide = in.guide();
    plane.symbols = in.symbols(layout, guides.make(guide, plane));
    guides.add(plane);
  }
  mistakes.terms.resize(in.number());
  mistakes.distances.resize(mistakes.terms.size());
  for (Symbols& term : mistakes.terms) term = in.symbols(layout, no_guide);
  for (Symbols& distance : mistakes.distances) distance = in.symbols(layout, no_guide);
  if (!in.at_end() || mistakes.planes.empty()) {
    throw MistakeDataError("the data of the mistakes are damaged");
  }
  return mistakes;
}

StageMistakes read_mistakes(const std::filesystem::path& path,
                            const std::vector<SceneText>& scenes) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw MistakeDataError(fmt::format("{} cannot be read", path.string()));
  return decode({std::istreambuf_iterator<char>(in), {}}, scenes);
}

const StageMistakes& mistakes_of(const Stage& stage) {
  static std::map<std::string_view, StageMistakes> kept;
  const auto found = kept.find(stage.id);
  if (found != kept.end()) return found->second;
  const std::filesystem::path folder = FOS_MISTAKES_DATA;
  return kept
      .emplace(stage.id,
               read_mistakes(folder / fmt::format("{}.mistakes", stage.id), base_scenes()))
      .first->second;
}

}  // namespace fos
