// Every word that a person reads, in English and in Greek: the catalogue of common/text/*.def.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fos {

enum class Language { en, el };

/// The language of this process: FOS_LANG (which `./lab --lang` sets), else LC_ALL, LC_MESSAGES or
/// LANG, the first that is not empty; Greek where it begins with `el`, English otherwise.
Language language();

/// One text in both languages. `{0}`, `{1}` … stand for what the program fills in. A text that
/// names other placeholders in one language than in the other does not compile.
struct Text {
  std::string_view en;
  std::string_view el;

  consteval Text(std::string_view english, std::string_view greek) : en(english), el(greek) {
    for (char digit = '0'; digit <= '9'; ++digit) {
      if (names(en, digit) != names(el, digit)) throw std::logic_error("placeholders differ");
    }
  }

 private:
  static constexpr bool names(std::string_view text, char digit) {
    const char placeholder[] = {'{', digit, '}'};
    return text.find(std::string_view(placeholder, 3)) != std::string_view::npos;
  }
};

/// The text in the language of this process, its placeholders filled in order.
std::string say(const Text& text, std::initializer_list<std::string_view> values = {});

// Defined once, in text_catalogue.cpp: comparing the placeholders takes the compiler seconds.
namespace text {
#define TEXT(name, english, greek) extern const Text name;
#include "texts.def"
#undef TEXT
}  // namespace text

}  // namespace fos
