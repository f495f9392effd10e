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
  const Clock::time_point now = Clock::now();
  if (done != done_) moved_ = now;
  done_ = done;
  if (!terminal_ || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  const auto seconds = [](Clock::duration time) {
    return std::to_string(std::chrono::round<std::chrono::seconds>(time).count());
  };
  const std::string percent = std::to_string(100 * done / total_);
  const bool stuck = now - moved_ > std::chrono::seconds(4);
  const std::string line =
      stuck       ? say(text::tool_stuck, {label_, percent, seconds(now - moved_)})
      : done == 0 ? say(text::tool_progress_start, {label_})
                  : say(text::tool_progress,
                        {label_, percent, seconds((now - start_) * (total_ - done) / done)});
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace fos
