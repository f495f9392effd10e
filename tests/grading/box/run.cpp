#include "grading/box/run.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <optional>
#include <utility>

#include "fos/supervised.hpp"

namespace fos::grading {
namespace {

using Clock = std::chrono::steady_clock;
using supervision::Cause;
using supervision::Word;

constexpr std::chrono::milliseconds waiting_step{250};
constexpr std::chrono::seconds patience{20};  // with the box's own end, on a busy machine too

class Descriptor {
 public:
  Descriptor() = default;
  /// Out of the way of 0 to 4.
  explicit Descriptor(int number) : number_(fcntl(number, F_DUPFD_CLOEXEC, 10)) { close(number); }
  ~Descriptor() { shut(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }
  void shut() {
    if (number_ >= 0) close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

/// The running errand. Whatever happens, it is ended and waited for.
class Running {
 public:
  explicit Running(std::vector<std::string> words) : error_(start(words)) {}

  ~Running() { end(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  int error() const { return error_; }
  Supervision& supervision() { return *supervision_; }

  /// Reads some of the output, if there is any. False once there is no more room.
  bool read_output(std::string& output, std::size_t most, bool cut) {
    std::array<char, std::size_t{16} * 1024> bytes{};
    const ssize_t count = read(heard_.number(), bytes.data(), bytes.size());
    if (count == 0) heard_.shut();
    if (count <= 0) return true;
    const auto came = static_cast<std::size_t>(count);
    const std::size_t room = most - output.size();
    output.append(bytes.data(), std::min(came, room));
    return came <= room || cut;
  }
  bool has_output() const {
    pollfd descriptor{heard_.number(), POLLIN, 0};
    return heard_.number() >= 0 && poll(&descriptor, 1, 0) > 0;
  }
  /// Where the output comes; -1 when there is no more.
  int descriptor() const { return heard_.number(); }

  void end() {
    if (process_ < 0) return;
    supervision_->shut();
    heard_.shut();
    supervision_->hear_end(patience);
    wait_or_kill(std::exchange(process_, -1), patience);
  }

 private:
  /// An errno, or 0.
  int start(std::vector<std::string>& words) {
    std::array<int, 2> output{-1, -1};
    std::array<int, 2> watched{-1, -1};
    if (pipe2(output.data(), O_CLOEXEC | O_NONBLOCK) != 0) return errno;
    Descriptor heard(output[0]);
    Descriptor printed(output[1]);
    fcntl(printed.number(), F_SETFL, 0);  // it may wait, we do not
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, watched.data()) != 0) {
      return errno;
    }
    Descriptor ours(watched[0]);
    Descriptor theirs(watched[1]);
    if (heard.number() < 0 || printed.number() < 0 || ours.number() < 0 || theirs.number() < 0) {
      return EMFILE;
    }

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, printed.number(), 1);
    posix_spawn_file_actions_adddup2(&actions, printed.number(), 2);
    posix_spawn_file_actions_addopen(&actions, 3, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, theirs.number(), supervision::descriptor);
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<char*, 1> environment{nullptr};
    // Ctrl-C is for the grader, who ends it in his own way.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawn(&process_, arguments[0], &actions, &attributes, arguments.data(),
                                  environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      process_ = -1;
      return error;
    }
    heard_ = std::move(heard);
    supervision_ = std::make_unique<Supervision>(ours.release());
    return 0;
  }

  pid_t process_ = -1;
  Descriptor heard_;
  std::unique_ptr<Supervision> supervision_;
  int error_;
};

RunEnding ending_of(const supervision::Message& end) {
  switch (end.cause) {
    case Cause::cpu:
    case Cause::idle:
    case Cause::asker:
      return RunEnding::out_of_time;
    case Cause::memory:
      return RunEnding::out_of_memory;
    case Cause::processes:
    case Cause::disk:
      return RunEnding::over_limit;
    case Cause::itself:
      break;
  }
  return WIFSIGNALED(end.status) ? RunEnding::signalled : RunEnding::exited;
}

}  // namespace

RunResult run(const Box& box, const Errand& errand, const RunLimits& limits,
              const std::function<void()>& on_wait) {
  RunResult result;
  Running running(box.command(errand));
  if (running.error() != 0) {
    result.status = running.error();
    return result;
  }
  Supervision& supervision = running.supervision();
  const auto start = Clock::now();
  auto last_wait = start;
  bool flooded = false;
  bool late = false;
  while (!supervision.is_over() && !flooded && !late) {
    supervision.hear(running.descriptor(), waiting_step);
    flooded = !running.read_output(result.output, limits.output, limits.cut);
    const auto now = Clock::now();
    if (now - last_wait < waiting_step) continue;
    last_wait = now;
    supervision.say(Word::waiting);
    on_wait();
    late = now - start > limits.wall;
  }
  while (!flooded && running.has_output()) {
    flooded = !running.read_output(result.output, limits.output, limits.cut);
  }
  running.end();

  const auto& end = supervision.ended();
  if (!supervision.started() || !end) {
    if (supervision.failed()) {
      result.status = supervision.failed()->status;
      result.step = supervision.failed()->step;
    }
    return result;
  }
  result.cpu_seconds = 1e-6 * static_cast<double>(end->cpu_microseconds);
  result.peak_memory = end->peak_bytes;
  result.ending = flooded ? RunEnding::flooded : ending_of(*end);
  if (result.ending == RunEnding::exited) result.status = WEXITSTATUS(end->status);
  if (result.ending == RunEnding::signalled) result.status = WTERMSIG(end->status);
  return result;
}

}  // namespace fos::grading
