#include "child.hpp"

#include <chrono>
#include <thread>

#include "catch2.hpp"

using namespace fos;

TEST_CASE("what a program says, and how it ends") {
  const Heard heard = run_heard({"sh", "-c", "echo one; echo two >&2; exit 7"}, {});
  CHECK(heard.words == "one\ntwo\n");
  CHECK(heard.status == 7);
  CHECK(run_heard({"sh", "-c", "kill -9 $$"}, {}).status == 137);
  CHECK(run_heard({"no such program"}, {}).status == 127);
  CHECK(run_heard({"cat"}, {}).status == 0);  // nothing to read, not the terminal
}

TEST_CASE("a program that is not wanted any more ends at once") {
  for (const char* words : {"sleep 60", "trap '' TERM; while :; do :; done"}) {
    INFO(words);
    std::stop_source stop;
    const auto began = std::chrono::steady_clock::now();
    std::jthread soon([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      stop.request_stop();
    });
    CHECK(run_heard({"sh", "-c", words}, stop.get_token()).status > 128);
    CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(10));
  }
}
