// Single keys, whatever the keyboard's layout is: a Greek one gives η where h is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fos {

enum class Key { hint, explain, list, next, check, quit, other };

/// Turns what a terminal sends into keys. A letter's bytes may come in two parts; an arrow or a
/// function key is one `other`.
class KeyReader {
 public:
  std::vector<Key> take(std::string_view bytes);

 private:
  std::string left_;  // the beginning of a letter
};

}  // namespace fos
