// The grammar of scene files: `key = value` lines and `name { key = value … }` blocks, of any
// names. Which keys there are, and what they may hold, is for scene_text.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fos/scene_text.hpp"

namespace fos {

enum class Shape { word, number, size, triple };  // ambient, 0.2, 600 x 600, (0, -1, 3)

struct Setting {
  std::string key;
  Place place;  ///< of the key
  Shape shape = Shape::word;
  std::string word;              ///< where shape is word
  std::vector<Decimal> numbers;  ///< 1, 2 or 3, as the shape says
  Place value_place;
};

struct Block {
  std::string name;
  Place place;
  std::vector<Setting> settings;
};

struct Document {
  std::vector<Setting> header;
  std::vector<Block> blocks;
};

/// Throws SceneError, with `name` as the file.
Document parse_document(std::string_view source, std::string_view name);

}  // namespace fos
