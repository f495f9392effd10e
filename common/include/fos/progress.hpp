// A progress line on the terminal, for what takes over a second.
#pragma once

#include <chrono>
#include <string>

namespace fos {

/// `label  43 %  12 s left` on standard error, one line, redrawn in place and wiped at the end.
/// Says nothing in the first second, nor where standard error is not a terminal. Where nothing gets
/// done for some seconds, it says that instead of a time.
class Progress {
 public:
  Progress(std::string label, long total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(long done);
  void wait() { update(done_); }  ///< to be called now and then while nothing gets done

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  long total_;
  bool terminal_;
  bool drawn_ = false;
  long done_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point moved_ = start_;  ///< when something got done last
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

}  // namespace fos
