// A progress line on the terminal, for what takes over a second.
#pragma once

#include <chrono>
#include <string>

namespace fos {

/// `label  43 %  12 s left` on standard error, one line, redrawn in place and wiped at the end.
/// Says nothing in the first second, nor where standard error is not a terminal.
class Progress {
 public:
  Progress(std::string label, long total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(long done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  long total_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

}  // namespace fos
