#include "clean_message.hpp"

#include <initializer_list>

namespace fos {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t i = text.find(from); i != std::string::npos;
       i = text.find(from, i + to.size())) {
    text.replace(i, from.size(), to);
  }
}

/// Behind the bracket that closes the one at `open`; npos where none does.
std::size_t behind_closing(std::string_view text, std::size_t open, char opening, char closing) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == opening) ++depth;
    if (text[i] == closing && --depth == 0) return i + 1;
  }
  return std::string_view::npos;
}

/// Replaces every `begin…`, which has an opening bracket, and all up to the closing one.
void replace_bracketed(std::string& text, std::string_view begin, char closing,
                       std::string_view to) {
  const std::size_t bracket = begin.find_first_of("{(<");
  for (std::size_t i = text.find(begin); i != std::string::npos; i = text.find(begin, i)) {
    const std::size_t end = behind_closing(text, i + bracket, begin[bracket], closing);
    if (end == std::string::npos) return;
    text.replace(i, end - i, to);
    i += to.size();
  }
}

/// `hit.std::optional<Hit>::operator->()->Hit::sphere` is g++'s hit->sphere.
void unfold_arrows(std::string& text) {
  constexpr std::string_view arrow = ">::operator->()";
  for (std::size_t i = text.find(arrow); i != std::string::npos; i = text.find(arrow)) {
    const std::size_t begin = text.rfind(".std::optional<", i);
    if (begin == std::string::npos) return;
    text.erase(begin, i + arrow.size() - begin);
  }
}

}  // namespace

std::string clean_message(std::string_view message) {
  std::string text(message);
  for (const std::string_view quote : {"\u2018", "\u2019"}) replace_all(text, quote, "'");
  replace_all(text, "`", "'");  // the linker's
  replace_bracketed(text, " {aka ", '}', "");
  replace_bracketed(text, " (aka ", ')', "");
  for (const std::string_view word : {"fos::", "const struct ", "const class "}) {
    replace_all(text, word, word.starts_with("const") ? "const " : "");
  }
  for (const std::string_view word : {"'struct ", "'class "}) replace_all(text, word, "'");
  for (const std::string_view vector :
       {"glm::vec<3, double", "glm::vec<3, float", "glm::vec<3, long double", "vec<3, double",
        "vec<3, float", "vec<3, long double"}) {
    for (std::size_t i = text.find(vector); i != std::string::npos; i = text.find(vector)) {
      const std::size_t end = behind_closing(text, text.find('<', i), '<', '>');
      if (end == std::string::npos) break;
      text.replace(i, end - i, "Vec3");
    }
  }
  replace_bracketed(text, ", std::allocator<", '>', "");
  replace_all(text, " >", ">");
  replace_all(text, "std::__cxx11::basic_string<char>", "std::string");
  unfold_arrows(text);
  for (const std::string_view member :
       {"Hit::", "Sphere::", "Scene::", "PointLight::", "DirectionalLight::"}) {
    replace_all(text, std::string("->").append(member), "->");
    replace_all(text, std::string(".").append(member), ".");
  }
  if (text.ends_with(']')) {
    const std::size_t flag = text.rfind(" [-");
    if (flag != std::string::npos) text.erase(flag);
  }
  return text;
}

}  // namespace fos
