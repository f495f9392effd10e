// The body of a reference file: one function for each part, for both directions (bits.hpp).

#include "reference_codec.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "bits.hpp"
#include "term_coder.hpp"

namespace fos::reference {
namespace {

/// More than a scene file of its largest size has spheres.
constexpr std::int64_t max_sphere = 1 << 20;

void require(bool condition, const char* what) {
  if (!condition) throw ReferenceError(what);
}

/// `count` numbers as runs of equal ones: the change from the run before, and the length less one.
template <class Bits, class Get, class Set>
void code_runs(Bits& bits, std::size_t count, Get get, Set set) {
  NumberCoder changes;
  NumberCoder lengths;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < count;) {
    std::int64_t change = 0;
    std::uint64_t more = 0;
    if constexpr (Bits::is_writing) {
      change = get(i) - last;
      while (i + more + 1 < count && get(i + more + 1) == get(i)) ++more;
    }
    changes.code(bits, change);
    lengths.code(bits, more);
    require(more < count - i, "a run is longer than the picture");
    require(change > -8 * max_sphere && change < 8 * max_sphere, "a run is out of range");
    last += change;
    for (std::uint64_t end = i + more + 1; i < end; ++i) set(i, last);
  }
}

/// Which sphere is seen, and whether each of its terms is more than 0. Reading marks such a term.
template <class Bits>
void code_regions(Bits& bits, std::vector<StoredPixel>& pixels) {
  code_runs(
      bits, pixels.size(),
      [&](std::size_t i) {
        const StoredPixel& pixel = pixels[i];
        return std::int64_t{4} * pixel.sphere + (pixel.point != 0 ? 2 : 0) +
               (pixel.directional != 0 ? 1 : 0);
      },
      [&](std::size_t i, std::int64_t region) {
        if constexpr (!Bits::is_writing) {
          require(region == 0 || (region >= 4 && region < 4 * max_sphere), "no such sphere");
          pixels[i].sphere = static_cast<std::int32_t>(region / 4);
          pixels[i].point = region / 2 % 2;
          pixels[i].directional = region % 2;
        }
      });
}

/// The terms that are more than 0, row by row; a row begins anew where another sphere does.
template <class Bits>
void code_terms(Bits& bits, std::vector<StoredPixel>& pixels, int width,
                std::int64_t StoredPixel::*term) {
  TermCoder coder;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    StoredPixel& pixel = pixels[i];
    const bool goes_on = i % static_cast<std::size_t>(width) != 0 &&
                         pixels[i - 1].sphere == pixel.sphere && pixels[i - 1].*term != 0;
    if (!goes_on) coder.restart();
    if (pixel.*term == 0) continue;
    coder.code(bits, pixel.*term);
    require(pixel.*term > 0, "a term is negative");
  }
}

/// The width codes of one precision and one kind of light, of all pixels but the background.
template <class Bits>
void code_widths(Bits& bits, std::vector<StoredPixel*>& hits, std::size_t precision,
                 std::uint8_t WidthCodes::*code) {
  code_runs(
      bits, hits.size(),
      [&](std::size_t i) { return std::int64_t{hits[i]->widths[precision].*code}; },
      [&](std::size_t i, std::int64_t width) {
        require(width >= 0 && width <= 255, "a width is out of range");
        hits[i]->widths[precision].*code = static_cast<std::uint8_t>(width);
      });
}

/// A number that is not negative, and less than `limit`.
template <class Bits, class Number>
void code_number(Bits& bits, NumberCoder& coder, Number& number, std::uint64_t limit) {
  auto n = static_cast<std::uint64_t>(number);
  coder.code(bits, n);
  require(n < limit, "a number is out of range");
  number = static_cast<Number>(n);
}

/// The pixels of one precision that accept several answers: the gap from the one before, how many
/// alternatives (0: not judged), and each of them.
template <class Bits>
void code_ambiguous(Bits& bits, std::vector<AmbiguousPixel>& list, std::size_t pixel_count) {
  NumberCoder counts, gaps, spheres, terms, widths;
  constexpr std::uint64_t max_term = std::uint64_t{1} << 62;
  std::uint64_t count = list.size();
  code_number(bits, counts, count, pixel_count + 1);
  std::uint64_t next = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    if constexpr (!Bits::is_writing) list.emplace_back();
    AmbiguousPixel& pixel = list[i];
    std::uint64_t gap = static_cast<std::uint64_t>(pixel.pixel) - next;
    code_number(bits, gaps, gap, pixel_count - next);
    pixel.pixel = static_cast<std::int32_t>(next + gap);
    next += gap + 1;
    std::uint64_t alternative_count = pixel.alternatives.size();
    code_number(bits, counts, alternative_count, 2 * max_sphere);
    pixel.judged = alternative_count > 0;
    for (std::uint64_t j = 0; j < alternative_count; ++j) {
      if constexpr (!Bits::is_writing) pixel.alternatives.emplace_back();
      StoredAlternative& alternative = pixel.alternatives[j];
      code_number(bits, spheres, alternative.sphere, max_sphere);
      if (alternative.sphere == 0) continue;
      code_number(bits, terms, alternative.point, max_term);
      code_number(bits, terms, alternative.directional, max_term);
      code_number(bits, widths, alternative.widths.point, 256);
      code_number(bits, widths, alternative.widths.directional, 256);
    }
  }
}

template <class Bits>
void code_body(Bits& bits, Reference& reference) {
  std::vector<StoredPixel>& pixels = reference.pixels;
  code_regions(bits, pixels);
  code_terms(bits, pixels, reference.width, &StoredPixel::point);
  code_terms(bits, pixels, reference.width, &StoredPixel::directional);
  std::vector<StoredPixel*> hits;
  for (StoredPixel& pixel : pixels) {
    if (pixel.sphere != 0) hits.push_back(&pixel);
  }
  for (std::size_t i = 0; i < precisions.size(); ++i) {
    code_widths(bits, hits, i, &WidthCodes::point);
    code_widths(bits, hits, i, &WidthCodes::directional);
    code_ambiguous(bits, reference.ambiguous[i], pixels.size());
  }
}

}  // namespace

std::string encode_body(Reference reference) {
  BitWriter bits;
  code_body(bits, reference);
  return bits.take();
}

void decode_body(std::span<const char> bytes, Reference& reference) {
  reference.pixels.assign(
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height),
      StoredPixel{});
  BitReader bits(bytes);
  code_body(bits, reference);
  require(bits.is_at_end(), "has too many bytes");
}

}  // namespace fos::reference
