#include "fos/stage_program.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <utility>

#include "exchange.hpp"
#include "fos/supervised.hpp"

namespace fos {
namespace {

void close_descriptor(int& descriptor) {
  if (descriptor >= 0) close(std::exchange(descriptor, -1));
}

/// The other ends of what a program has open; -1 for none.
struct Ends {
  int requests = -1;
  int frames = -1;
  int printed = -1;
  int supervision = -1;
  int errors = -1;
};

/// In the child, between vfork and exec: only calls that are safe there. (It borrows the stack, on
/// which a sanitizer would leave its marks.)
[[noreturn, gnu::no_sanitize_address]] void become(char* const* words, Ends ends, int cpu_seconds,
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
  // They may be any numbers: copy them out of the way of 0 to 4 first.
  for (int* end : {&ends.requests, &ends.frames, &ends.printed, &ends.supervision, &ends.errors}) {
    if (*end >= 0) *end = fcntl(*end, F_DUPFD_CLOEXEC, 10);
  }
  dup2(ends.requests, 0);
  if (ends.printed >= 0) dup2(ends.printed, 1);
  if (ends.printed >= 0) dup2(ends.printed, 2);
  dup2(ends.frames, 3);
  if (ends.supervision >= 0) {
    dup2(ends.supervision, supervision::descriptor);
    setpgid(0, 0);  // Ctrl-C is for the asker, who ends it in his own way
  }
  execv(words[0], words);
  const int error = errno;
  [[maybe_unused]] const ssize_t told = write(ends.errors, &error, sizeof(error));
  _exit(127);
}

bool open_nowhere(int& descriptor) {
  descriptor = open("/dev/null", O_WRONLY | O_CLOEXEC);
  return descriptor >= 0;
}

/// How long a supervisor may take to end what it runs, on a busy machine too.
constexpr std::chrono::seconds patience_with_supervisor{20};

}  // namespace

StageProgram::StageProgram(const std::filesystem::path& program, Limits limits)
    : words_of_command_{program.string()}, limits_(limits) {}

StageProgram::StageProgram(SupervisedCommand command, Limits limits)
    : words_of_command_(std::move(command.words)), supervised_(true), limits_(limits) {}

StageProgram::~StageProgram() { stop(); }

bool StageProgram::start() {
  std::array<int, 2> requests{-1, -1};
  std::array<int, 2> frames{-1, -1};
  std::array<int, 2> printed{-1, -1};
  std::array<int, 2> watched{-1, -1};
  std::array<int, 2> errors{-1, -1};
  int error = 0;
  const bool opened = socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, requests.data()) == 0 &&
                      pipe2(frames.data(), O_CLOEXEC) == 0 &&
                      (!limits_.hear || pipe2(printed.data(), O_CLOEXEC) == 0) &&
                      (limits_.hear || !supervised_ || open_nowhere(printed[1])) &&
                      (!supervised_ || socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0,
                                                  watched.data()) == 0) &&
                      pipe2(errors.data(), O_CLOEXEC) == 0;
  if (!opened) error = errno;
  if (opened) {
    const pid_t parent = getpid();
    std::vector<char*> words;
    for (auto& word : words_of_command_) words.push_back(word.data());
    std::string fresh = "--fresh";
    if (limits_.fresh) words.push_back(fresh.data());
    words.push_back(nullptr);
    const Ends ends{requests[1], frames[1], printed[1], watched[1], errors[1]};
    // vfork: a frame may be large, and copying the page tables of one who holds some costs more
    // than all the rest of a start. Until exec the child uses this process's memory, and leaves it
    // alone.
    process_ = vfork();  // NOLINT(*Vfork,*vfork)
    if (process_ == 0) become(words.data(), ends, supervised_ ? 0 : limits_.cpu_seconds, parent);
    if (process_ < 0) error = errno;
    close_descriptor(errors[1]);
    // exec closes the pipe without a word; a failed one writes its errno first.
    if (process_ > 0 && read(errors[0], &error, sizeof(error)) > 0) stop();
  }
  for (int* descriptor :
       {&requests[1], &frames[1], &printed[1], &watched[1], &errors[0], &errors[1]}) {
    close_descriptor(*descriptor);
  }
  requests_ = requests[0];
  frames_ = frames[0];
  printed_ = printed[0];
  if (watched[0] >= 0) supervision_ = std::make_unique<Supervision>(watched[0]);
  if (error != 0) stop();
  errno = error;
  return error == 0;
}

int StageProgram::stop() {
  close_descriptor(requests_);
  close_descriptor(frames_);
  int status = 0;
  if (process_ > 0 && supervision_) {
    supervision_->shut();
    supervision_->hear_end(patience_with_supervisor);
    status = wait_or_kill(process_, patience_with_supervisor);
  } else if (process_ > 0) {
    kill(process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  if (supervision_ && supervision_->ended()) {
    cpu_seconds_ += 1e-6 * static_cast<double>(supervision_->ended()->cpu_microseconds);
  }
  close_descriptor(printed_);
  supervision_.reset();
  process_ = -1;
  return status;
}

Answer StageProgram::supervised_ending(Answer answer, bool late, Exchange& exchange) {
  const auto ended = [&](Ending ending, int detail = 0) {
    answer.ending = ending;
    answer.detail = detail;
    return answer;
  };
  // The frame's pipe is shut, so the program has ended or is about to. One that goes on without it
  // is ended.
  exchange.hear_the_rest();
  supervision_->hear_end(std::chrono::seconds(late ? 0 : 2));
  const bool malformed = !late && supervision_->started() && !supervision_->ended();
  supervision_->shut();
  supervision_->hear_end(patience_with_supervisor);
  exchange.hear_the_rest();
  const bool started = supervision_->started();
  const auto end = supervision_->ended();
  const auto failure = supervision_->failed();
  stop();
  if (!started) return ended(Ending::did_not_start, failure ? failure->status : 0);
  if (late) return ended(Ending::timed_out);
  if (malformed) return ended(Ending::malformed);
  if (!end) return ended(Ending::did_not_start);  // the box is gone, and nobody knows why
  switch (end->cause) {
    case supervision::Cause::cpu:
      return ended(Ending::timed_out, SIGXCPU);
    case supervision::Cause::idle:
    case supervision::Cause::asker:
      return ended(Ending::timed_out);
    case supervision::Cause::memory:
      return ended(Ending::out_of_memory);
    case supervision::Cause::itself:
    case supervision::Cause::processes:
    case supervision::Cause::disk:
      break;
  }
  if (WIFSIGNALED(end->status)) return ended(Ending::crashed, WTERMSIG(end->status));
  return ended(Ending::exited, WEXITSTATUS(end->status));
}

Answer StageProgram::ask(const Request& request, const HeaderSink& on_header,
                         const ReceivedRow& on_row, const WaitSink& on_wait) {
  Answer answer;
  const auto ended = [&](Ending ending, int detail = 0) {
    answer.ending = ending;
    answer.detail = detail;
    return answer;
  };
  words_.clear();
  if (process_ < 0 && !start()) return ended(Ending::did_not_start, errno);

  if (supervision_) supervision_->say(supervision::Word::question);
  const WaitSink on_waiting = [&] {
    if (supervision_) supervision_->say(supervision::Word::waiting);
    on_wait();
  };
  Exchange exchange(requests_, frames_, printed_, words_, encode(request), limits_.wall,
                    on_waiting);
  const auto broken = [&](Exchange::Result result) {
    if (supervision_) {
      return supervised_ending(answer, result == Exchange::Result::late, exchange);
    }
    exchange.hear_the_rest();
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
  const auto width = static_cast<std::size_t>(header->width);
  const std::size_t pixel_size = encoded_row_size(*header) / width - 1;  // without its flag
  for (; answer.rows < header->height; ++answer.rows) {
    result = exchange.receive(bytes);
    if (result != Exchange::Result::filled) {
      std::size_t received = exchange.received();
      if (result == Exchange::Result::late) {
        // As at its limit of processor time: it leaves its pixels.
        if (supervision_) supervision_->say(supervision::Word::enough);
        if (!supervision_) kill(process_, SIGXCPU);
        received += exchange.receive_last(std::span(bytes).subspan(received));
      }
      answer.pixels = static_cast<int>(std::min(received / pixel_size, width));
      return broken(result);
    }
    on_row(answer.rows, decode_row(*header, bytes));
  }
  exchange.hear_the_rest();
  return answer;
}

Answer StageProgram::ask(const Request& request, Frame& frame, const WaitSink& on_wait) {
  frame = {};
  return ask(
      request,
      [&](const FrameHeader& header) {
        frame.header = header;
        const auto pixels =
            static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
        frame.channels.reserve(3 * pixels);
        frame.unwritten.reserve(pixels);
      },
      [&](int /*row*/, const Row& row) { frame.append(row); }, on_wait);
}

}  // namespace fos
