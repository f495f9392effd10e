#include "keys.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace fos {
namespace {

struct Meaning {
  Key key;
  std::string_view letter;
};

// Latin and Greek, small and large; c gives ψ, and q a question mark (;) or a colon. Control-D, the
// end of the input, is a quit.
constexpr std::array meanings{
    Meaning{Key::hint, "h"},    Meaning{Key::hint, "H"},    Meaning{Key::hint, "η"},
    Meaning{Key::hint, "Η"},    Meaning{Key::explain, "e"}, Meaning{Key::explain, "E"},
    Meaning{Key::explain, "ε"}, Meaning{Key::explain, "Ε"}, Meaning{Key::list, "l"},
    Meaning{Key::list, "L"},    Meaning{Key::list, "λ"},    Meaning{Key::list, "Λ"},
    Meaning{Key::next, "n"},    Meaning{Key::next, "N"},    Meaning{Key::next, "ν"},
    Meaning{Key::next, "Ν"},    Meaning{Key::check, "c"},   Meaning{Key::check, "C"},
    Meaning{Key::check, "ψ"},   Meaning{Key::check, "Ψ"},   Meaning{Key::quit, "q"},
    Meaning{Key::quit, "Q"},    Meaning{Key::quit, ";"},    Meaning{Key::quit, ":"},
    Meaning{Key::quit, "\x04"}};

Key key_of(std::string_view letter) {
  const auto found = std::find_if(meanings.begin(), meanings.end(),
                                  [&](const Meaning& each) { return each.letter == letter; });
  return found == meanings.end() ? Key::other : found->key;
}

/// Of a letter in UTF-8, by its first byte.
std::size_t length(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
}

/// Of what an arrow or a function key sends: ESC [ … up to a letter or ~, or ESC O and a letter;
/// else ESC alone.
std::size_t escape_length(std::string_view bytes) {
  if (bytes.size() < 2 || (bytes[1] != '[' && bytes[1] != 'O')) return 1;
  std::size_t end = 2;
  while (end < bytes.size() && (bytes[end] < '@' || bytes[end] > '~')) ++end;
  return std::min(end + 1, bytes.size());
}

}  // namespace

std::vector<Key> KeyReader::take(std::string_view bytes) {
  const std::string all = std::exchange(left_, "") + std::string(bytes);
  std::vector<Key> keys;
  for (std::size_t i = 0; i < all.size();) {
    const std::string_view rest = std::string_view(all).substr(i);
    const bool escape = rest.front() == '\033';
    const std::size_t size = escape ? escape_length(rest) : length(rest.front());
    if (size > rest.size()) {
      left_ = rest;
      break;
    }
    keys.push_back(escape ? Key::other : key_of(rest.substr(0, size)));
    i += size;
  }
  return keys;
}

}  // namespace fos
