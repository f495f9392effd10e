#include "fos/supervised.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

namespace fos {

Supervision::~Supervision() { close(socket_); }

void Supervision::say(supervision::Word word) const {
  // A supervisor that is gone, or that has more words waiting than it can take, is told nothing.
  [[maybe_unused]] const ssize_t said =
      send(socket_, &word, sizeof(word), MSG_NOSIGNAL | MSG_DONTWAIT);
}

void Supervision::shut() const { shutdown(socket_, SHUT_WR); }

void Supervision::hear(int other, std::chrono::milliseconds patience) {
  std::array<pollfd, 2> descriptors{pollfd{socket_, POLLIN, 0}, pollfd{other, POLLIN, 0}};
  const int ready = poll(descriptors.data(), descriptors.size(),
                         static_cast<int>(std::max<std::int64_t>(patience.count(), 0)));
  if (ready <= 0 || descriptors[0].revents == 0) return;
  supervision::Message message;
  const ssize_t size = recv(socket_, &message, sizeof(message), MSG_DONTWAIT);
  // ECONNRESET: it left before it had heard all of ours; its own last word is still to be heard.
  if (size < 0 && (errno == EINTR || errno == EAGAIN || errno == ECONNRESET)) return;
  if (size != static_cast<ssize_t>(sizeof(message))) {
    gone_ = true;
    return;
  }
  switch (message.event) {
    case supervision::Event::started:
      started_ = true;
      break;
    case supervision::Event::not_started:
      failed_ = message;
      break;
    case supervision::Event::ended:
      ended_ = message;
      break;
  }
}

void Supervision::hear_end(std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + patience;
  while (!is_over()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(last - Clock::now());
    hear(-1, left);
    if (left.count() <= 0) return;
  }
}

int wait_or_kill(int process, std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + patience;
  int status = 0;
  for (useconds_t pause = 50; Clock::now() < last; pause = std::min(2 * pause, 10'000U)) {
    const pid_t gone = waitpid(process, &status, WNOHANG);
    if (gone == process || (gone < 0 && errno != EINTR)) return status;
    usleep(pause);
  }
  kill(process, SIGKILL);
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace fos
