#include "exchange.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace fos {
namespace {

constexpr std::size_t most_words = 4096;
constexpr std::chrono::milliseconds waiting_step{250};

bool is_to_be_tried_again() { return errno == EINTR || errno == EAGAIN; }

}  // namespace

Exchange::Result Exchange::receive(std::span<char> bytes) {
  received_ = 0;
  while (received_ < bytes.size()) {
    std::array<pollfd, 3> descriptors{pollfd{frames_, POLLIN, 0},
                                      pollfd{to_send_.empty() ? -1 : requests_, POLLOUT, 0},
                                      pollfd{printed_, POLLIN, 0}};
    const int ready = poll(descriptors.data(), descriptors.size(), waiting_step.count());
    if (is_late()) return Result::late;
    if (Clock::now() - last_sign_ >= waiting_step) {
      on_wait_();
      last_sign_ = Clock::now();
    }
    if (ready <= 0) continue;
    if (descriptors[1].revents != 0) send_some();
    if (descriptors[2].revents != 0) hear_some();
    if (descriptors[0].revents == 0) continue;
    const auto left = bytes.subspan(received_);
    const ssize_t count = read(frames_, left.data(), left.size());
    if (count < 0 && is_to_be_tried_again()) continue;
    if (count <= 0) return Result::closed;
    received_ += static_cast<std::size_t>(count);
    last_sign_ = Clock::now();
  }
  return Result::filled;
}

std::size_t Exchange::receive_last(std::span<char> bytes) {
  wall_ = std::chrono::milliseconds(100);
  start_ = Clock::now();
  receive(bytes);
  return received_;
}

void Exchange::send_some() {
  const ssize_t sent =
      send(requests_, to_send_.data(), to_send_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent > 0) to_send_.erase(0, static_cast<std::size_t>(sent));
  // A program that is gone cannot be sent to; that it is gone shows on the other descriptor.
  if (sent < 0 && !is_to_be_tried_again()) to_send_.clear();
}

void Exchange::hear_some() {
  std::array<char, most_words> bytes{};
  const ssize_t count = read(printed_, bytes.data(), bytes.size());
  if (count < 0 && is_to_be_tried_again()) return;
  if (count <= 0) {
    printed_ = -1;  // nothing comes any more
    return;
  }
  const std::size_t room = most_words - std::min(most_words, words_.size());
  words_.append(bytes.data(), std::min(static_cast<std::size_t>(count), room));
}

void Exchange::hear_the_rest() {
  for (;;) {
    pollfd descriptor{printed_, POLLIN, 0};
    if (printed_ < 0 || poll(&descriptor, 1, 0) <= 0) return;
    hear_some();
  }
}

}  // namespace fos
