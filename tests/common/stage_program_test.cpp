#include "fos/stage_program.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>

#include "catch2.hpp"

using namespace fos;

namespace {

struct Outcome {
  Answer answer;
  Frame frame;
};

Outcome ask(const char* misbehaviour, Limits limits = {std::chrono::seconds(10), 10}) {
  setenv("MISBEHAVIOUR", misbehaviour, 1);
  StageProgram program(FOS_MISBEHAVING, limits);
  Outcome outcome;
  outcome.answer = program.ask({"name", "text", 2, 2}, outcome.frame);
  return outcome;
}

}  // namespace

TEST_CASE("a whole frame is received, again and again from one program") {
  setenv("MISBEHAVIOUR", "none", 1);
  StageProgram program(FOS_MISBEHAVING);
  for (int i = 0; i < 3; ++i) {
    Frame frame;
    const Answer answer = program.ask({"name", std::string(500'000, ' '), 2, 2}, frame);
    CHECK(answer.ending == Ending::complete);
    CHECK(answer.rows == 2);
    REQUIRE(frame.channels.size() == 12);
    CHECK(frame.pixel(1, 1)[2] == 6);
    CHECK(frame.is_unwritten(1, 0));
    CHECK_FALSE(frame.is_unwritten(0, 1));
  }
}

TEST_CASE("a crash is an answer, with the rows that came") {
  const Outcome outcome = ask("crashes");
  CHECK(outcome.answer.ending == Ending::crashed);
  CHECK(outcome.answer.detail == SIGABRT);
  CHECK(outcome.answer.rows == 1);
  CHECK(outcome.frame.channels.size() == 6);
}

TEST_CASE("a program that ends in the middle of a row says at which pixel") {
  const Outcome outcome = ask("prints and crashes", {std::chrono::seconds(10), 10, true});
  CHECK(outcome.answer.ending == Ending::crashed);
  CHECK(outcome.answer.rows == 1);
  CHECK(outcome.answer.pixels == 1);
}

TEST_CASE("what a program prints is kept, and never more than a few KiB of it") {
  setenv("MISBEHAVIOUR", "prints and crashes", 1);
  StageProgram program(FOS_MISBEHAVING, {std::chrono::seconds(10), 10, true});
  Frame frame;
  program.ask({"name", "text", 2, 2}, frame);
  CHECK(program.words() == std::string(4096, '-'));
}

TEST_CASE("what never ends is ended, by the clock or by its processor time") {
  CHECK(ask("sleeps", {std::chrono::milliseconds(100), 0}).answer.ending == Ending::timed_out);
  CHECK(ask("does not read", {std::chrono::milliseconds(100), 0}).answer.ending ==
        Ending::timed_out);
  CHECK(ask("loops", {std::chrono::milliseconds(100), 0}).answer.ending == Ending::timed_out);
  CHECK(ask("loops", {std::chrono::seconds(30), 1}).answer.ending == Ending::timed_out);
}

TEST_CASE("whoever waits is told, again and again") {
  setenv("MISBEHAVIOUR", "sleeps", 1);
  StageProgram program(FOS_MISBEHAVING, {std::chrono::milliseconds(900), 0});
  int waits = 0;
  program.ask(
      {"name", "text", 2, 2}, [](const FrameHeader&) {}, [](int, const Row&) {}, [&] { ++waits; });
  CHECK(waits >= 2);
}

TEST_CASE("exit status and text prove nothing: only a whole frame counts") {
  CHECK(ask("says passed and exits").answer.ending == Ending::exited);
  const Outcome ends = ask("ends");
  CHECK(ends.answer.ending == Ending::exited);
  CHECK(ends.answer.detail == 0);
}

TEST_CASE("what is not a frame of the size asked for is malformed") {
  CHECK(ask("garbage").answer.ending == Ending::malformed);
  CHECK(ask("wrong size").answer.ending == Ending::malformed);
  CHECK(ask("closes").answer.ending == Ending::malformed);
}

TEST_CASE("a scene that the program cannot carry is refused, which is no crash") {
  CHECK(ask("refuses").answer.ending == Ending::refused);
  CHECK(ask("exits with 2").answer.ending == Ending::exited);
}

TEST_CASE("a program that is not there is not the stage's fault") {
  Frame frame;
  StageProgram program("no/such/program");
  const Answer answer = program.ask({"name", "text", 2, 2}, frame);
  CHECK(answer.ending == Ending::did_not_start);
  CHECK(answer.detail == ENOENT);
}

TEST_CASE("after a crash the next question starts the program anew") {
  setenv("MISBEHAVIOUR", "crashes", 1);
  StageProgram program(FOS_MISBEHAVING);
  Frame frame;
  CHECK(program.ask({"name", "text", 2, 2}, frame).ending == Ending::crashed);
  setenv("MISBEHAVIOUR", "none", 1);
  CHECK(program.ask({"name", "text", 2, 2}, frame).ending == Ending::complete);
}
