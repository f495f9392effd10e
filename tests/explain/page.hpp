// Lines of 80 columns: what is right, what is yours, and how they stand to each other.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fos {

enum class Mark {
  none,    ///< nothing to compare
  unseen,  ///< does not show from outside
  same,
  different,
  open,  ///< not judged, or not told
};

class Page {
 public:
  /// Colors mark what is the same, what differs and what does not show.
  explicit Page(bool colors) : colors_(colors) {}

  /// A line as it is.
  void line(std::string_view words = "");
  /// Words in lines of at most 80 columns.
  void paragraph(std::string_view words);
  /// A row of the table.
  void row(std::string_view name, std::string_view right, std::string_view yours, Mark mark);

  const std::string& text() const { return text_; }

 private:
  std::string painted(std::string_view words, Mark mark) const;

  bool colors_;
  std::string text_;
};

}  // namespace fos
