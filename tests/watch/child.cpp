#include "child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

#include "signals.hpp"

namespace fos {
namespace {

std::vector<char*> arguments_of(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  return arguments;
}

int as_shell_has_it(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// The child, between fork and exec: only calls that are safe there.
[[noreturn]] void become_heard(char* const* arguments, int output, pid_t parent) {
  release_signals();
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);
  setpgid(0, 0);  // the terminal's Ctrl-C is not for it
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execvp(arguments[0], arguments);
  _exit(127);
}

/// The rest of what a program says, until it ends or this is asked to stop.
std::string hear(int output, const std::stop_token& stop) {
  std::string words;
  std::array<char, 8192> bytes{};
  while (!stop.stop_requested()) {
    pollfd descriptor{output, POLLIN, 0};
    if (poll(&descriptor, 1, 20) <= 0) continue;
    const ssize_t count = read(output, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    words.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return words;
}

/// Tells it to end, so that it takes what it has started with it; a second later it is killed.
void end(pid_t process) {
  kill(process, SIGTERM);
  for (int wait = 0; wait < 100; ++wait) {
    siginfo_t info{};
    if (waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
        info.si_pid != 0) {
      return;
    }
    usleep(10'000);
  }
  kill(-process, SIGKILL);
}

}  // namespace

Heard run_heard(const std::vector<std::string>& command, const std::stop_token& stop) {
  Heard heard;
  std::array<int, 2> pipe_ends{-1, -1};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return heard;
  const std::vector<char*> arguments = arguments_of(command);
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process == 0) become_heard(arguments.data(), pipe_ends[1], parent);
  close(pipe_ends[1]);
  if (process > 0) {
    heard.words = hear(pipe_ends[0], stop);
    if (stop.stop_requested()) end(process);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    heard.status = as_shell_has_it(status);
  }
  close(pipe_ends[0]);
  return heard;
}

int run_in_terminal(const std::vector<std::string>& command) {
  const std::vector<char*> arguments = arguments_of(command);
  const pid_t process = fork();
  if (process == 0) {
    release_signals();
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  if (process < 0) return 127;
  int status = 0;
  for (;;) {
    if (waitpid(process, &status, WUNTRACED) < 0) {
      if (errno != EINTR) return 127;
    } else if (WIFSTOPPED(status)) {
      raise(SIGSTOP);
      kill(process, SIGCONT);
    } else {
      return as_shell_has_it(status);
    }
  }
}

}  // namespace fos
