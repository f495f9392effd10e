// What ends an errand, and that it is told apart.
#include "grading/box/run.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

#include "catch2.hpp"
#include "grading/box/box_under_test.hpp"

using namespace fos::grading;
using namespace std::chrono_literals;

TEST_CASE("a program's own end is told as it is") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  CHECK(run(box, attack("nothing")).succeeded());
  const auto exited = run(box, attack("exits with 134"));
  CHECK(exited.ending == RunEnding::exited);
  CHECK(exited.status == 134);
  const auto aborted = run(box, attack("aborts"));
  CHECK(aborted.ending == RunEnding::signalled);
  CHECK(aborted.status == SIGABRT);
}

TEST_CASE("a program that is not there is the box's trouble, not its own") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  Errand missing = attack("nothing");
  missing.words[0] = "/box/missing";
  const auto result = run(box, missing);
  CHECK(result.ending == RunEnding::infrastructure);
  CHECK(result.status == ENOENT);
  Errand nothing_to_show = attack("nothing");
  nothing_to_show.shown.push_back({test_folder() / "no such file", "/box/other"});
  if (box.level() != Level::uid) {
    CHECK(run(box, nothing_to_show).ending == RunEnding::infrastructure);
  }
}

TEST_CASE("processor time is counted, also of many processes and of a program that ignores it") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  const auto spins = run(box, attack("spins"));
  CHECK(spins.ending == RunEnding::out_of_time);
  CHECK(spins.cpu_seconds > 1.5);
  CHECK(spins.cpu_seconds < 4);
  const auto many = run(box, attack("spins in many"));
  // Where no signal goes to other processes it does not even see that they live, and forks more.
  CHECK((many.ending == RunEnding::out_of_time || many.ending == RunEnding::over_limit));
  CHECK(many.cpu_seconds < 5);
}

TEST_CASE("a program that does nothing is ended, and so is one that nearly does nothing") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  const auto start = std::chrono::steady_clock::now();
  CHECK(run(box, attack("sleeps")).ending == RunEnding::out_of_time);
  CHECK(run(box, attack("dozes")).ending == RunEnding::out_of_time);
  CHECK(std::chrono::steady_clock::now() - start < 30s);
}

TEST_CASE("a busy machine fails nobody") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  std::atomic<bool> stop{false};
  std::vector<std::thread> others(std::size_t{16} * std::thread::hardware_concurrency());
  for (auto& other : others) {
    other = std::thread([&stop] {
      while (!stop) {
      }
    });
  }
  Errand computes = attack("computes");
  computes.limits.cpu_seconds = 1;
  computes.limits.idle_seconds = 1;
  const auto start = std::chrono::steady_clock::now();
  const auto result = run(box, computes);
  const auto wall = std::chrono::steady_clock::now() - start;
  stop = true;
  for (auto& other : others) other.join();
  CHECK(result.succeeded());
  if (wall < 2s) WARN("the program was not starved here");
}

TEST_CASE("the clock ends what escapes all else") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  RunLimits limits;
  limits.wall = 300ms;
  CHECK(run(box, attack("sleeps"), limits).ending == RunEnding::out_of_time);
}

TEST_CASE("memory is counted over all processes") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  const auto many = run(box, attack("takes memory in many"));
  INFO("status " << many.status << ", step " << many.step << ", " << many.output);
  CHECK(many.ending == RunEnding::out_of_memory);
  Errand one = attack("takes memory");
  const auto reserved = run(box, one);  // more than may even be reserved
  CHECK(reserved.ending == RunEnding::exited);
  CHECK(reserved.status == 3);
  one.limits.address_space = false;
  const auto used = run(box, one);
  CHECK(used.ending == RunEnding::out_of_memory);
  CHECK(used.peak_memory < (std::uint64_t{1} << 30));
}

TEST_CASE("output is kept up to its cap") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  RunLimits limits;
  limits.output = 10'000;
  const auto flooded = run(box, attack("floods"), limits);
  CHECK(flooded.ending == RunEnding::flooded);
  CHECK(flooded.output == std::string(10'000, 'x'));
  limits.cut = true;
  const auto cut = run(box, attack("floods"), limits);
  CHECK(cut.ending == RunEnding::out_of_time);
  CHECK(cut.output.size() == 10'000);
}

TEST_CASE("files are limited one by one and all together") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  const auto huge = run(box, attack("writes a huge file"));
  CHECK_FALSE(huge.succeeded());
  CHECK(huge.output.size() < 9);  // less than 100 MB were written
  const auto many = run(box, attack("writes many files"));
  CHECK_FALSE(many.succeeded());
  // On a slow disk its time may be over first.
  if (box.level() == Level::bubblewrap) CHECK(many.ending == RunEnding::over_limit);
}

TEST_CASE("who waits may leave, and the errand ends") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  CHECK_THROWS_AS(run(box, attack("sleeps"), {}, [] { throw std::runtime_error("Ctrl-C"); }),
                  std::runtime_error);
}
