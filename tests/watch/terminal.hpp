// The terminal, borrowed: keys come one at a time and are not shown, and however the program ends,
// the terminal is again as it was found.
#pragma once

#include <string>

namespace fos {

/// One at a time in a process.
class Terminal {
 public:
  /// Takes it over where standard input and output are a terminal; else does nothing.
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Whether there is one.
  bool is_there() const { return there_; }

  void take();       ///< keys one at a time, not shown; Ctrl-C and Ctrl-Z stay signals
  void give_back();  ///< as it was found: for a child, or for a line to be typed

  struct Size {
    int columns = 80;
    int rows = 24;
  };
  Size size() const;

  /// Empties the window without losing anything: what was in it before the first time moves up
  /// where one can scroll back to it.
  void clear();

 private:
  bool there_;
  bool cleared_ = false;
};

/// Writes to standard output at once, all of it.
void show(const std::string& words);

}  // namespace fos
