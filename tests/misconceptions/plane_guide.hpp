// What the planes that come first in the data suggest for the next one. Two mistakes made together
// look much like one of them with a third that is akin to the other: what is left to store is
// little.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mistake_data.hpp"

namespace fos {

struct Guide {
  /// The plane, counted from 0, that is the guide; none is a plane of zeros.
  std::optional<std::size_t> plane;
  /// Whether what the mistakes change, each alone, is taken into account: those of the guide's
  /// plane are taken away, and those of the next plane added.
  bool corrected = false;
};

class PlaneGuides {
 public:
  /// For planes of so many symbols.
  explicit PlaneGuides(std::size_t size) : size_(size) {}

  /// The next plane of the data. Keeps a reference to it.
  void add(const Plane& plane) { planes_.push_back(&plane); }

  /// All guides of a plane that may be of use.
  std::vector<Guide> of(const Plane& plane) const;

  /// A guide of a plane whose mistakes are known. Differences are taken modulo 2^16. Throws
  /// MistakeDataError for one that is not there.
  Symbols make(const Guide& guide, const Plane& plane) const;

 private:
  /// The plane of one mistake, or the right one. Throws MistakeDataError.
  const Symbols& alone(std::optional<Mistake> mistake) const;

  std::size_t size_;
  std::vector<const Plane*> planes_;  // the right one first
};

}  // namespace fos
