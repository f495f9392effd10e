#include "terminal.hpp"

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace fos {
namespace {

// What the handler of a crash needs: plain memory.
termios found{};
volatile std::sig_atomic_t is_taken = 0;

constexpr int crashes[] = {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL};

extern "C" void give_back_and_crash(int signal) {
  if (is_taken != 0) tcsetattr(STDIN_FILENO, TCSANOW, &found);
  raise(signal);  // once more, and not handled: SA_RESETHAND
}

/// In the background the terminal belongs to another, who has set it for himself.
bool is_ours() { return tcgetpgrp(STDIN_FILENO) == getpgrp(); }

}  // namespace

Terminal::Terminal()
    : there_(isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1 &&
             tcgetattr(STDIN_FILENO, &found) == 0) {
  if (!there_) return;
  struct sigaction action {};
  action.sa_handler = give_back_and_crash;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : crashes) sigaction(signal, &action, nullptr);
  take();
}

Terminal::~Terminal() {
  give_back();
  if (!there_) return;
  for (const int signal : crashes) std::signal(signal, SIG_DFL);
}

void Terminal::take() {
  if (!there_ || !is_ours()) return;
  termios raw = found;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  is_taken = 1;
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

void Terminal::give_back() {
  if (!there_ || is_taken == 0) return;
  if (is_ours()) tcsetattr(STDIN_FILENO, TCSANOW, &found);
  is_taken = 0;
}

Terminal::Size Terminal::size() const {
  winsize window{};
  Size size;
  if (!there_ || ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0) return size;
  if (window.ws_col > 0) size.columns = window.ws_col;
  if (window.ws_row > 0) size.rows = window.ws_row;
  return size;
}

void Terminal::clear() {
  if (!there_) return;
  if (!cleared_) show(std::string(static_cast<std::size_t>(size().rows), '\n'));
  cleared_ = true;
  show("\033[H\033[J");
}

void show(const std::string& words) {
  for (std::size_t shown = 0; shown < words.size();) {
    const ssize_t count = write(STDOUT_FILENO, words.data() + shown, words.size() - shown);
    if (count > 0) shown += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR && errno != EAGAIN) return;  // nobody reads any more
  }
}

}  // namespace fos
