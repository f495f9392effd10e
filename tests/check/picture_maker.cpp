#include "picture_maker.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "fos/text.hpp"

namespace fos {
namespace {

using Clock = std::chrono::steady_clock;

/// Whether the socket is ready for `event` before the deadline.
bool wait_for(int socket, short event, Clock::time_point deadline) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return false;
    pollfd descriptor{socket, event, 0};
    const int ready = poll(&descriptor, 1, static_cast<int>(left.count()));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
  }
}

/// In the child, between vfork and exec: only calls that are safe there.
[[noreturn]] void become(const char* program, int socket) {
  // Ctrl-C is for the one who asks: this program ends when its input does.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGQUIT, SIG_IGN);
  std::signal(SIGTSTP, SIG_IGN);
  dup2(socket, STDIN_FILENO);
  dup2(socket, STDOUT_FILENO);
  char serve[] = "serve";
  char* const arguments[] = {const_cast<char*>(program), serve, nullptr};
  execv(program, arguments);
  _exit(127);
}

}  // namespace

PictureMaker::PictureMaker(std::filesystem::path program) : program_(std::move(program)) {
  start();
}

PictureMaker::~PictureMaker() { stop(); }

void PictureMaker::start() {
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  // A megabyte at a time, not the 200 KiB of a socket.
  const int room = 4 << 20;
  setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &room, sizeof(room));
  process_ = vfork();
  if (process_ == 0) become(program_.c_str(), ends[1]);
  close(ends[1]);
  socket_ = ends[0];
  if (process_ < 0) stop();
}

void PictureMaker::stop() {
  if (socket_ >= 0) close(std::exchange(socket_, -1));
  if (process_ > 0) {
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  process_ = -1;
}

bool PictureMaker::send(const std::string& bytes, Clock::time_point deadline) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    if (!wait_for(socket_, POLLOUT, deadline)) return false;
    const ssize_t count =
        ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) sent += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR && errno != EAGAIN) return false;
  }
  return true;
}

std::string PictureMaker::receive_line(Clock::time_point deadline) {
  std::string line;
  while (line.empty() || line.back() != '\n') {
    if (!wait_for(socket_, POLLIN, deadline)) return "";
    std::array<char, 4096> bytes{};
    const ssize_t count = recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return "";
    line.append(bytes.data(), static_cast<std::size_t>(count));
  }
  line.pop_back();
  return line;
}

bool PictureMaker::failed(const std::string& why) {
  error_ = why;
  return false;
}

bool PictureMaker::make(const PictureJob& job) {
  error_.clear();
  if (process_ < 0) start();
  if (process_ < 0) return failed(std::strerror(errno));
  const Clock::time_point deadline = Clock::now() + patience;
  const std::string answer = send(encode(job), deadline) ? receive_line(deadline) : "";
  if (answer == picture_made) return true;
  if (!answer.empty()) return failed(answer);
  stop();
  return failed(say(text::watch_no_picture_program, {program_.filename().string()}));
}

}  // namespace fos
