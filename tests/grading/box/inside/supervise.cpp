#include "supervise.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

#include "census.hpp"
#include "child.hpp"
#include "fos/supervision.hpp"

namespace fos::grading::inside {
namespace {

using supervision::Cause;
using supervision::Event;
using supervision::Message;
using supervision::Word;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto waiting_step = 250ms;  // how often the asker says that it waits

void tell(const Message& message) {
  [[maybe_unused]] const ssize_t told =
      send(supervision::descriptor, &message, sizeof(message), MSG_NOSIGNAL);
}

class Supervisor {
 public:
  explicit Supervisor(const Settings& settings) : settings_(settings) {}

  void run() {
    prepare();
    if (!start()) return;
    tell({});
    while (!ended_) {
      watch();
      reap();
    }
    end_all();
    Message message;
    message.event = Event::ended;
    message.cause = cause_ == Cause::itself ? cause_of(status_) : cause_;
    message.status = status_;
    message.cpu_microseconds = counter_.cpu();
    message.peak_bytes = peak_;
    tell(message);
  }

 private:
  void prepare() {
    fcntl(supervision::descriptor, F_SETFD, FD_CLOEXEC);
    syscall(SYS_close_range, supervision::descriptor + 1, ~0U, 0);
    prctl(PR_SET_DUMPABLE, 0);  // nobody in the box opens what this process has open
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    // It ends with its asker by itself, after what it has started.
    if (!settings_.alone) prctl(PR_SET_PDEATHSIG, 0);
    for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_IGN);
    std::signal(SIGCHLD, SIG_DFL);
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    sigprocmask(SIG_BLOCK, &child, nullptr);
    children_ = signalfd(-1, &child, SFD_CLOEXEC | SFD_NONBLOCK);
  }

  bool start() {
    std::array<int, 2> errors{-1, -1};
    Failure failure{Step::fork, 0};
    if (pipe2(errors.data(), O_CLOEXEC) == 0) {
      program_ = fork();
      if (program_ == 0) become_program(settings_, errors[1]);
    }
    if (program_ < 0) failure.error = errno;
    for (int own = 0; own < supervision::descriptor; ++own) close(own);
    close(errors[1]);
    counter_ = Counter(program_);
    if (failure.error == 0 && read(errors[0], &failure, sizeof(failure)) != sizeof(failure)) {
      close(errors[0]);
      return true;
    }
    Message message;
    message.event = Event::not_started;
    message.status = failure.error;
    message.step = static_cast<std::uint32_t>(failure.step);
    tell(message);
    return false;
  }

  /// Until the next look at what is used, or until something happens.
  void watch() {
    std::array<pollfd, 2> descriptors{pollfd{supervision::descriptor, POLLIN, 0},
                                      pollfd{children_, POLLIN, 0}};
    poll(descriptors.data(), descriptors.size(), near_limit_ ? 5 : 50);
    if (descriptors[0].revents != 0) listen();
    if (descriptors[1].revents != 0) {
      signalfd_siginfo information{};
      while (read(children_, &information, sizeof(information)) > 0) {
      }
    }
    if (Clock::now() >= next_look_) look();
  }

  void listen() {
    char word = 0;
    const ssize_t size = recv(supervision::descriptor, &word, 1, MSG_DONTWAIT);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) return finish(Cause::asker);
    switch (static_cast<Word>(word)) {
      case Word::question:
        counter_.count();
        spent_before_ = counter_.cpu();
        idle_ = {};
        break;
      case Word::waiting:
        hear_waiting();
        break;
      case Word::enough:
        finish(Cause::asker);
        break;
    }
  }

  /// It is waited for: does it do anything? On a busy machine it may not come to it, but wants to.
  void hear_waiting() {
    const auto now = Clock::now();
    if (now - last_waiting_ < waiting_step / 2) return;  // said while this process was not awake
    last_waiting_ = now;
    const Census census = counter_.count();
    const std::uint64_t spent = counter_.cpu();
    const bool computes = spent > spent_at_waiting_ + 20'000;
    spent_at_waiting_ = spent;
    if (!census.wants_to_run && !computes) idle_ += waiting_step;
    if (idle_ >= std::chrono::seconds(settings_.idle_seconds)) finish(Cause::idle);
  }

  void look() {
    const Census census = counter_.count();
    peak_ = std::max(peak_, census.memory);
    near_limit_ = census.memory > settings_.memory / 2;
    next_look_ = Clock::now() + (near_limit_ ? 5ms : 50ms);
    if (census.memory > settings_.memory) return finish(Cause::memory);
    if (census.processes > settings_.processes + 1) return finish(Cause::processes);
    // The kernel's limit of one process comes first, by a second: this one is for all together.
    const std::uint64_t most = (settings_.cpu_seconds + 1) * 1'000'000ULL + 500'000;
    if (counter_.cpu() > spent_before_ + most) return finish(Cause::cpu);
    if (!settings_.scratch.empty() && ++looks_ % 4 == 0 &&
        holds_more_than(settings_.scratch, settings_.written)) {
      finish(Cause::disk);
    }
  }

  /// Ends the program, which has a moment to leave the pixels that it has.
  void finish(Cause cause) {
    if (ended_) return;
    cause_ = cause;
    kill(-program_, SIGXCPU);
    const auto last = Clock::now() + 100ms;
    while (!ended_ && Clock::now() < last) {
      usleep(1000);
      reap();
    }
    ended_ = true;
  }

  void reap() {
    int status = 0;
    pid_t gone = 0;
    while ((gone = waitpid(-1, &status, WNOHANG)) > 0) {
      if (gone != program_) continue;
      ended_ = true;
      reaped_ = true;
      status_ = status;
      rusage used{};
      getrusage(RUSAGE_CHILDREN, &used);
      peak_ = std::max(peak_, static_cast<std::uint64_t>(used.ru_maxrss) * 1024);
    }
  }

  /// All of the session is one process group, for which the kernel has one kill that nobody
  /// outruns. In a namespace of its own, there is one for all.
  void end_all() {
    counter_.count();
    for (int options = WNOHANG;; options = 0) {  // if there is nobody, nobody is killed
      int status = 0;
      const pid_t gone = waitpid(-1, &status, options);
      if (gone < 0 && errno == ECHILD) return;
      if (gone == program_ && !reaped_) status_ = status;
      kill(settings_.alone ? -1 : -program_, SIGKILL);
    }
  }

  Cause cause_of(int status) const {
    if (!WIFSIGNALED(status)) return Cause::itself;
    const int signal = WTERMSIG(status);
    const bool spent = counter_.cpu() >= spent_before_ + settings_.cpu_seconds * 1'000'000ULL;
    if (signal == SIGXCPU || (signal == SIGKILL && spent)) return Cause::cpu;
    return signal == SIGXFSZ ? Cause::disk : Cause::itself;
  }

  const Settings& settings_;
  Counter counter_{0};
  int children_ = -1;  // a descriptor that tells of SIGCHLD
  pid_t program_ = -1;
  bool ended_ = false;
  bool reaped_ = false;
  bool near_limit_ = false;
  unsigned looks_ = 0;
  int status_ = 0;
  Cause cause_ = Cause::itself;
  std::uint64_t peak_ = 0;
  std::uint64_t spent_before_ = 0;      // processor time when the question came
  std::uint64_t spent_at_waiting_ = 0;  // and when it was last waited for
  std::chrono::milliseconds idle_{0};
  Clock::time_point last_waiting_;
  Clock::time_point next_look_ = Clock::now() + 20ms;
};

}  // namespace

void supervise(const Settings& settings) { Supervisor(settings).run(); }

}  // namespace fos::grading::inside
