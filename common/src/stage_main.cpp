// The main of every stage program: scenes in on what was its standard input, frames out on
// descriptor 3, for as many requests as come. Standard output and error are the student's, to print
// what they like, and standard input is empty.
//
// A stage that ends in mid-row, by a crash or at its limit of time, leaves the pixels of that row
// that it had made: so the asker knows at which pixel it ended.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <string_view>
#include <system_error>

#include "fos/frame.hpp"
#include "fos/request.hpp"
#include "fos/scene_file.hpp"
#include "fos/text.hpp"

namespace {

constexpr int frame_descriptor = 3;

constexpr fos::Precision precision = std::same_as<fos::Real, float>    ? fos::Precision::binary32
                                     : std::same_as<fos::Real, double> ? fos::Precision::binary64
                                                                       : fos::Precision::extended;

void write_all(std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(frame_descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw std::system_error(errno, std::generic_category());
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

fos::RowInTheMaking making;

/// The pixels that the unfinished row has, also in a signal's handler: only calls that are safe
/// there.
void leave_pixels() {
  const auto pixels = static_cast<std::size_t>(making.pixels.exchange(0));
  if (pixels == 0) return;
  [[maybe_unused]] const ssize_t told =
      write(frame_descriptor, making.colors.data(), pixels * sizeof(fos::Color));
}

void leave_pixels_and_die(int signal) {
  leave_pixels();
  raise(signal);  // by its default: SA_RESETHAND
}

/// On a stack of its own, since an endless recursion ends where there is none left. Where a
/// sanitizer has come first it stays: it says more.
void leave_pixels_on_signals() {
  static char stack[1 << 16];
  const stack_t aside{stack, 0, sizeof(stack)};
  sigaltstack(&aside, nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) {
    struct sigaction action = {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = leave_pixels_and_die;
    action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
}

void render_frame(const fos::SceneFile& file) {
  const fos::FrameHeader header{file.view.canvas_width, file.view.canvas_height, precision};
  write_all(fos::encode(header));
  std::vector<char> bytes(fos::encoded_row_size(header));
  const auto send_row = [&](auto colors, auto unwritten) {
    static_assert(sizeof(fos::Color) == 3 * sizeof(fos::Real));
    std::memcpy(bytes.data(), colors.data(), colors.size_bytes());
    std::memcpy(bytes.data() + colors.size_bytes(), unwritten.data(), unwritten.size());
    write_all(bytes);
  };
  fos::render(file.scene, file.view, send_row, making);
}

void answer(const fos::Request& request) {
  fos::SceneFile file;
  try {
    file = fos::to_scene(fos::parse_scene_text(request.scene_text, request.scene_name));
  } catch (const fos::SceneError& error) {
    std::cerr << error.what() << '\n';
    write_all(fos::encode(fos::FrameHeader()));
    return;
  }
  file.view.canvas_width = request.width;
  file.view.canvas_height = request.height;
  render_frame(file);
}

/// The requests, with standard input left empty for the stage.
std::FILE* take_requests() {
  std::FILE* requests = fdopen(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, frame_descriptor + 1), "r");
  if (requests == nullptr || std::freopen("/dev/null", "r", stdin) == nullptr) {
    throw std::system_error(errno, std::generic_category());
  }
  return requests;
}

// --fresh: one process reads the requests, and a copy of it answers each.

pid_t copy = 0;

/// Answers by a copy that ends with it. Where the copy ends in another way, so does this process.
void answer_fresh(const fos::Request& request) {
  // Shared with the copy: whether the whole frame went out. A stage may call exit(0) too.
  static auto* const whole = static_cast<bool*>(
      mmap(nullptr, sizeof(bool), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (whole == MAP_FAILED) throw std::system_error(errno, std::generic_category());
  *whole = false;
  const pid_t reader = getpid();
  copy = fork();
  if (copy < 0) throw std::system_error(errno, std::generic_category());
  if (copy == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != reader) _exit(127);
    std::signal(SIGXCPU, SIG_DFL);
    leave_pixels_on_signals();
    answer(request);
    *whole = true;
    std::cout.flush();
    std::fflush(nullptr);
    _exit(0);
  }
  int status = 0;
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  copy = 0;
  if (WIFSIGNALED(status)) {
    std::signal(WTERMSIG(status), SIG_DFL);
    raise(WTERMSIG(status));
  }
  if (!*whole) _exit(WEXITSTATUS(status));
}

/// The asker's word that time is up is for the copy.
void hand_on(int signal) {
  if (copy > 0) kill(copy, signal);
}

}  // namespace

int main(int argc, char** argv) {
  const bool fresh = argc > 1 && std::string_view(argv[1]) == "--fresh";
  if (fcntl(frame_descriptor, F_GETFD) == -1) {
    std::cerr << fos::say(fos::text::stage_run_by_lab) << '\n';
    return 2;
  }
  try {
    std::atexit(leave_pixels);  // a stage may call exit() too
    if (fresh) {
      std::signal(SIGXCPU, hand_on);
    } else {
      leave_pixels_on_signals();
    }
    std::FILE* requests = take_requests();
    while (const auto request = fos::read_request(requests)) {
      fresh ? answer_fresh(*request) : answer(*request);
    }
  } catch (const std::system_error& error) {  // nobody reads the frame, or a descriptor is shut
    std::cerr << error.what() << '\n';
    return 3;
  } catch (const std::exception& error) {
    std::cerr << fos::say(fos::text::stage_exception, {error.what()}) << '\n';
    return 1;
  }
}
