// Where the pixels of a plane lie, and what a pixel's neighbours suggest for its symbol.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fos/scene_text.hpp"
#include "mistake_data.hpp"

namespace fos {

class SymbolLayout {
 public:
  /// The pixels of the scenes, one after the other. Where `spheres` are given only those have a
  /// symbol that see one. Keeps the pointer.
  SymbolLayout(const std::vector<SceneText>& scenes, const std::vector<std::uint16_t>* spheres);

  std::size_t size() const { return pixels_.size(); }
  bool has_symbol(std::size_t i) const { return spheres_ == nullptr || (*spheres_)[i] != 0; }

  /// The number of pixel i of a plane, from those to the left, above, and left above, those that
  /// there are: the plane through them, or the nearer end of the range of the first two where it
  /// leaves that (the predictor of LOCO-I: Weinberger, Seroussi, Sapiro, "The LOCO-I lossless image
  /// compression algorithm", 2000).
  int predict(const std::vector<int>& numbers, std::size_t i) const;

 private:
  struct Place {
    std::size_t width;
    bool has_left;
    bool has_above;
  };
  std::vector<Place> pixels_;
  const std::vector<std::uint16_t>* spheres_;
};

}  // namespace fos
