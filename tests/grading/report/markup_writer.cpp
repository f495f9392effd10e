#include "markup_writer.hpp"

#include "escape.hpp"

namespace fos::grading {

MarkupWriter& MarkupWriter::raw(Literal markup) {
  out_ += markup.text();
  return *this;
}

MarkupWriter& MarkupWriter::add(const MarkupWriter& other) {
  out_ += other.out_;
  return *this;
}

MarkupWriter& MarkupWriter::text(std::string_view words) {
  out_ += markup(words);
  return *this;
}

MarkupWriter& MarkupWriter::number(long value) {
  out_ += std::to_string(value);
  return *this;
}

MarkupWriter& MarkupWriter::attribute(Literal name, std::string_view value) {
  out_.append(" ").append(name.text()).append(R"(=")");
  for (const char c : markup(value)) {
    if (c == '\n' || c == '\t') {
      out_.append("&#").append(std::to_string(static_cast<int>(c))).append(";");
    } else {
      out_ += c;
    }
  }
  out_ += '"';
  return *this;
}

MarkupWriter& MarkupWriter::attribute(Literal name, long value) {
  return attribute(name, std::to_string(value));
}

MarkupWriter& MarkupWriter::element(Literal name, std::string_view words) {
  return element(name, "", words);
}

MarkupWriter& MarkupWriter::element(Literal name, Literal css_class, std::string_view words) {
  if (words.empty()) return *this;
  out_.append("<").append(name.text());
  if (!css_class.text().empty()) attribute("class", css_class.text());
  raw(">").text(words);
  out_.append("</").append(name.text()).append(">");
  return *this;
}

}  // namespace fos::grading
