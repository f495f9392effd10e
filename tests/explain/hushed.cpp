#include "hushed.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <iostream>

namespace fos {

Hushed::Hushed() {
  std::cout.flush();
  std::cerr.flush();
  output_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 10);
  error_ = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 10);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  std::array<int, 2> pipe_ends{-1, -1};
  // Not blocking: who prints for ever fills it and goes on.
  if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
  if (pipe2(pipe_ends.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
    words_ = pipe_ends[0];
    dup2(pipe_ends[1], STDERR_FILENO);
    close(pipe_ends[1]);
  }
  if (nowhere >= 0) close(nowhere);
}

Hushed::~Hushed() {
  if (output_ >= 0) dup2(output_, STDOUT_FILENO);
  if (error_ >= 0) dup2(error_, STDERR_FILENO);
  for (const int descriptor : {output_, error_, words_}) {
    if (descriptor >= 0) close(descriptor);
  }
}

std::string Hushed::take_words() const {
  std::string words;
  std::array<char, 4096> some{};
  for (ssize_t count = 0; (count = read(words_, some.data(), some.size())) > 0;) {
    words.append(some.data(), static_cast<std::size_t>(count));
  }
  return words;
}

}  // namespace fos
