#include "plane_guide.hpp"

namespace fos {
namespace {

/// Whether two planes have a mistake in common; the right one has with all.
bool are_akin(const Plane& a, const Plane& b) {
  return !a.first || a.first == b.first || a.first == b.second ||
         (a.second && (a.second == b.first || a.second == b.second));
}

}  // namespace

std::vector<Guide> PlaneGuides::of(const Plane& plane) const {
  std::vector<Guide> guides{{}};
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (plane.second ? !are_akin(*planes_[i], plane) : planes_[i]->second.has_value()) continue;
    guides.push_back({i, false});
    if (plane.second) guides.push_back({i, true});
  }
  return guides;
}

const Symbols& PlaneGuides::alone(std::optional<Mistake> mistake) const {
  for (const Plane* plane : planes_) {
    if (plane->first == mistake && !plane->second) return plane->symbols;
  }
  throw MistakeDataError("the data of the mistakes are damaged");
}

Symbols PlaneGuides::make(const Guide& guide, const Plane& plane) const {
  if (!guide.plane) return Symbols(size_);
  if (*guide.plane >= planes_.size()) {
    throw MistakeDataError("the data of the mistakes are damaged");
  }
  const Plane& akin = *planes_[*guide.plane];
  Symbols symbols = akin.symbols;
  if (!guide.corrected) return symbols;
  const Symbols& first = alone(plane.first);
  const Symbols& second = alone(plane.second);
  const Symbols& first_of_akin = alone(akin.first);
  const Symbols& second_of_akin = alone(akin.second);
  for (std::size_t i = 0; i < size_; ++i) {
    symbols[i] = static_cast<std::uint16_t>(symbols[i] + first[i] + second[i] - first_of_akin[i] -
                                            second_of_akin[i]);
  }
  return symbols;
}

}  // namespace fos
