// A stage may print. While it is asked a dozen questions about one pixel, nobody wants to
// read that.
#pragma once

#include <string>

namespace fos {

/// While one lives, what is printed on standard output goes nowhere, and of standard error
/// the first 64 KiB are kept: by this process, and by those that it starts meanwhile. One at
/// a time.
class Hushed {
 public:
  Hushed();
  ~Hushed();
  Hushed(const Hushed&) = delete;
  Hushed& operator=(const Hushed&) = delete;

  /// What came on standard error so far and was not taken yet.
  std::string take_words() const;

 private:
  int output_ = -1;  // the real ones, kept
  int error_ = -1;
  int words_ = -1;  // the pipe's end to read
};

}  // namespace fos
