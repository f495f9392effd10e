// Answers as its MISBEHAVIOUR says. Every answer to anything but "nothing" starts with a right
// frame of 2 x 2 pixels, or with part of one.
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "fos/frame.hpp"
#include "fos/request.hpp"

namespace {

void send(const void* bytes, std::size_t count) {
  [[maybe_unused]] const ssize_t sent = write(3, bytes, count);
}

void send_rows(int rows) {
  const double channels[6] = {1, 2, 3, 4, 5, 6};
  const char flags[2] = {0, 1};
  for (int row = 0; row < rows; ++row) {
    send(channels, sizeof(channels));
    send(flags, sizeof(flags));
  }
}

}  // namespace

int main() {
  const char* variable = std::getenv("MISBEHAVIOUR");
  const std::string kind = variable == nullptr ? "none" : variable;
  if (kind == "does not read") pause();
  const auto header = fos::encode({2, kind == "wrong size" ? 3 : 2, fos::Precision::binary64});
  while (fos::read_request(stdin)) {
    if (kind == "exits with 2") return 2;
    if (kind == "refuses") {
      const auto refusal = fos::encode(fos::FrameHeader());
      send(refusal.data(), refusal.size());
      continue;
    }
    if (kind == "says passed and exits") {
      std::cout << "100% tests passed\n" << std::flush;
      _exit(0);
    }
    if (kind == "garbage") {
      send("this is no frame at all, and long enough", 40);
      pause();
    }
    send(header.data(), header.size());
    if (kind == "loops" || kind == "sleeps" || kind == "crashes" || kind == "ends") send_rows(1);
    if (kind == "prints and crashes") {
      std::cout << std::string(100'000, '-') << std::flush;
      send_rows(1);
      const double pixel[3] = {1, 2, 3};
      send(pixel, sizeof(pixel));
      std::abort();
    }
    if (kind == "closes") close(3);
    if (kind == "crashes") std::abort();
    if (kind == "ends") _exit(0);
    if (kind == "loops") {
      volatile bool for_ever = true;
      while (for_ever) {
      }
    }
    if (kind == "sleeps" || kind == "closes") pause();
    send_rows(2);
  }
}
