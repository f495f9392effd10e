#include "fos/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "fos/text.hpp"

namespace fos {

Progress::Progress(std::string label, long total)
    : label_(std::move(label)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::update(long done) {
  if (!terminal_ || done <= 0 || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(100);
  const std::chrono::duration<double> passed = Clock::now() - start_;
  const double left =
      passed.count() * static_cast<double>(total_ - done) / static_cast<double>(done);
  const std::string line = say(
      text::tool_progress,
      {label_, std::to_string(100 * done / total_), std::to_string(static_cast<long>(left + 0.5))});
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace fos
