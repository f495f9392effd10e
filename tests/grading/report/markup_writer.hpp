// HTML and XML, put together so that nothing goes in unescaped by mistake.
#pragma once

#include <string>
#include <string_view>

namespace fos::grading {

/// What comes from a program's source, and so from no student: only a literal converts to it.
class Literal {
 public:
  consteval Literal(const char* text) : text_(text) {}
  constexpr std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};

class MarkupWriter {
 public:
  /// As it is.
  MarkupWriter& raw(Literal markup);
  /// What another writer has made.
  MarkupWriter& add(const MarkupWriter& other);
  /// Escaped.
  MarkupWriter& text(std::string_view words);
  MarkupWriter& number(long value);
  /// ` name="value"`, the value escaped; line ends are kept.
  MarkupWriter& attribute(Literal name, std::string_view value);
  MarkupWriter& attribute(Literal name, long value);
  /// `<name>words</name>`, the words escaped; nothing where there are none.
  MarkupWriter& element(Literal name, std::string_view words);
  /// The same with a class.
  MarkupWriter& element(Literal name, Literal css_class, std::string_view words);

  const std::string& str() const { return out_; }

 private:
  std::string out_;
};

}  // namespace fos::grading
