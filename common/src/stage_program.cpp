#include "fos/stage_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <utility>

namespace fos {
namespace {

using Clock = std::chrono::steady_clock;

void close_descriptor(int& descriptor) {
  if (descriptor >= 0) close(std::exchange(descriptor, -1));
}

/// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void become(const char* program, int requests, int frames, int errors, int cpu_seconds,
                         pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // never outlive the asker, however it ends
  if (getppid() != parent) _exit(127);
  if (cpu_seconds > 0) {
    const auto seconds = static_cast<rlim_t>(cpu_seconds);
    const rlimit cpu{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &cpu);
  }
  const rlimit core{0, 0};
  setrlimit(RLIMIT_CORE, &core);
  std::signal(SIGPIPE, SIG_DFL);
  // Both may be any number: copy them out of the way of 0 and 3 first.
  const int in = fcntl(requests, F_DUPFD_CLOEXEC, 10);
  const int out = fcntl(frames, F_DUPFD_CLOEXEC, 10);
  errors = fcntl(errors, F_DUPFD_CLOEXEC, 10);
  dup2(in, 0);
  dup2(out, 3);
  char* const arguments[] = {const_cast<char*>(program), nullptr};
  execv(program, arguments);
  const int error = errno;
  [[maybe_unused]] const ssize_t told = write(errors, &error, sizeof(error));
  _exit(127);
}

/// Sends requests and receives frames of one answer, against one deadline.
class Exchange {
 public:
  Exchange(int requests, int frames, std::string to_send, std::chrono::milliseconds wall,
           const WaitSink& on_wait)
      : requests_(requests),
        frames_(frames),
        to_send_(std::move(to_send)),
        wall_(wall),
        on_wait_(on_wait) {}

  enum class Result { filled, closed, late };

  /// Fills `bytes` from the program, while the request is still on its way too.
  Result receive(std::span<char> bytes) {
    while (!bytes.empty()) {
      std::array<pollfd, 2> descriptors{pollfd{frames_, POLLIN, 0},
                                        pollfd{to_send_.empty() ? -1 : requests_, POLLOUT, 0}};
      const int ready = poll(descriptors.data(), descriptors.size(), 250);
      if (is_late()) return Result::late;
      if (ready == 0) on_wait_();
      if (ready <= 0) continue;
      if (descriptors[1].revents != 0) send_some();
      if (descriptors[0].revents == 0) continue;
      const ssize_t count = read(frames_, bytes.data(), bytes.size());
      if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (count <= 0) return Result::closed;
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return Result::filled;
  }

 private:
  void send_some() {
    const ssize_t sent =
        send(requests_, to_send_.data(), to_send_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) to_send_.erase(0, static_cast<std::size_t>(sent));
    // A program that is gone cannot be sent to; that it is gone shows on the other descriptor.
    if (sent < 0 && errno != EAGAIN && errno != EINTR) to_send_.clear();
  }

  bool is_late() const { return wall_.count() > 0 && Clock::now() - start_ > wall_; }

  int requests_;
  int frames_;
  std::string to_send_;
  std::chrono::milliseconds wall_;
  const WaitSink& on_wait_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

StageProgram::StageProgram(std::filesystem::path program, Limits limits)
    : program_(std::move(program)), limits_(limits) {}

StageProgram::~StageProgram() { stop(); }

bool StageProgram::start() {
  std::array<int, 2> requests{-1, -1};
  std::array<int, 2> frames{-1, -1};
  std::array<int, 2> errors{-1, -1};
  int error = 0;
  const bool opened = socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, requests.data()) == 0 &&
                      pipe2(frames.data(), O_CLOEXEC) == 0 && pipe2(errors.data(), O_CLOEXEC) == 0;
  if (!opened) error = errno;
  if (opened) {
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ == 0) {
      become(program_.c_str(), requests[1], frames[1], errors[1], limits_.cpu_seconds, parent);
    }
    if (process_ < 0) error = errno;
    close_descriptor(errors[1]);
    // exec closes the pipe without a word; a failed one writes its errno first.
    if (process_ > 0 && read(errors[0], &error, sizeof(error)) > 0) stop();
  }
  for (int* descriptor : {&requests[1], &frames[1], &errors[0], &errors[1]}) {
    close_descriptor(*descriptor);
  }
  requests_ = requests[0];
  frames_ = frames[0];
  if (error != 0) stop();
  errno = error;
  return error == 0;
}

int StageProgram::stop() {
  close_descriptor(requests_);
  close_descriptor(frames_);
  int status = 0;
  if (process_ > 0) {
    kill(process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  process_ = -1;
  return status;
}

Answer StageProgram::ask(const Request& request, const HeaderSink& on_header,
                         const ReceivedRow& on_row, const WaitSink& on_wait) {
  Answer answer;
  const auto ended = [&](Ending ending, int detail = 0) {
    answer.ending = ending;
    answer.detail = detail;
    return answer;
  };
  if (process_ < 0 && !start()) return ended(Ending::did_not_start, errno);

  Exchange exchange(requests_, frames_, encode(request), limits_.wall, on_wait);
  const auto broken = [&](Exchange::Result result) {
    if (result == Exchange::Result::late) {
      stop();
      return ended(Ending::timed_out);
    }
    // The frame's pipe is shut. A moment for the program to end by itself, so that its own status
    // is seen and not our kill.
    int status = 0;
    for (int wait = 0; wait < 200; ++wait) {
      if (waitpid(process_, &status, WNOHANG) == process_) {
        process_ = -1;
        break;
      }
      usleep(1000);
    }
    if (process_ > 0) {
      stop();
      return ended(Ending::malformed);
    }
    stop();
    if (WIFSIGNALED(status)) {
      const int signal = WTERMSIG(status);
      return ended(signal == SIGXCPU ? Ending::timed_out : Ending::crashed, signal);
    }
    return ended(Ending::exited, WEXITSTATUS(status));
  };

  std::array<char, encoded_header_size> header_bytes{};
  auto result = exchange.receive(header_bytes);
  if (result != Exchange::Result::filled) return broken(result);
  if (header_bytes == encode(FrameHeader())) return ended(Ending::refused);
  const auto header = decode_header(header_bytes);
  if (!header || header->width != request.width || header->height != request.height) {
    stop();
    return ended(Ending::malformed);
  }
  answer.header = *header;
  on_header(*header);
  std::vector<char> bytes(encoded_row_size(*header));
  for (; answer.rows < header->height; ++answer.rows) {
    result = exchange.receive(bytes);
    if (result != Exchange::Result::filled) return broken(result);
    on_row(answer.rows, decode_row(*header, bytes));
  }
  return answer;
}

Answer StageProgram::ask(const Request& request, Frame& frame) {
  frame = {};
  return ask(
      request, [&](const FrameHeader& header) { frame.header = header; },
      [&](int /*row*/, const Row& row) { frame.append(row); });
}

}  // namespace fos
