// StageProgram asks a program in the box as it asks one outside.
#include <chrono>
#include <csignal>

#include "catch2.hpp"
#include "fos/stage_program.hpp"
#include "grading/box/box_under_test.hpp"

using namespace fos;
using namespace fos::grading;
using namespace std::chrono_literals;

namespace {

namespace fs = std::filesystem;

struct Outcome {
  Answer answer;
  Frame frame;
  std::string words;
};

SupervisedCommand command(const Box& box, const std::string& misbehaviour) {
  static const fs::path program = [] {
    fs::path copy = test_folder() / "misbehaving";
    fs::copy_file(FOS_MISBEHAVING, copy, fs::copy_options::overwrite_existing);
    return copy;
  }();
  Errand errand = attack("");
  errand.words = {"/box/stage"};
  errand.shown = {{program, "/box/stage"}};
  errand.environment = {"MISBEHAVIOUR=" + misbehaviour};
  return {box.command(errand)};
}

Outcome ask(const std::string& misbehaviour, Limits limits = {60s, 0, true}) {
  const Box box = make_box();
  StageProgram program(command(box, misbehaviour), limits);
  Outcome outcome;
  outcome.answer = program.ask({"name", "text", 2, 2}, outcome.frame);
  outcome.words = program.words();
  return outcome;
}

}  // namespace

TEST_CASE("frames come out of the box, again and again from one program") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  StageProgram program(command(box, "none"));
  for (int i = 0; i < 3; ++i) {
    Frame frame;
    CHECK(program.ask({"name", std::string(500'000, ' '), 2, 2}, frame).ending == Ending::complete);
    REQUIRE(frame.channels.size() == 12);
    CHECK(frame.pixel(1, 1)[2] == 6);
  }
  program.end();
  CHECK(program.cpu_seconds() > 0);
}

TEST_CASE("in the box a stage's end is told as it is outside") {
  FOS_NEEDS_BOX();
  const Outcome crash = ask("prints and crashes");
  CHECK(crash.answer.ending == Ending::crashed);
  CHECK(crash.answer.detail == SIGABRT);
  CHECK(crash.answer.rows == 1);
  CHECK(crash.answer.pixels == 1);
  CHECK(crash.words == std::string(4096, '-'));
  CHECK(ask("ends").answer.ending == Ending::exited);
  const Outcome fake = ask("says passed and exits");
  CHECK(fake.answer.ending == Ending::exited);
  CHECK(fake.words == "100% tests passed\n");
  CHECK(ask("garbage").answer.ending == Ending::malformed);
  CHECK(ask("wrong size").answer.ending == Ending::malformed);
  CHECK(ask("closes").answer.ending == Ending::malformed);
  CHECK(ask("refuses").answer.ending == Ending::refused);
  CHECK(ask("exits with 2").answer.detail == 2);
}

TEST_CASE("in the box processor time ends a stage that spins, and waiting one that sleeps") {
  FOS_NEEDS_BOX();
  const Outcome loops = ask("loops");
  CHECK(loops.answer.ending == Ending::timed_out);
  CHECK(loops.answer.detail == SIGXCPU);
  CHECK(loops.answer.rows == 1);
  CHECK(ask("sleeps").answer.ending == Ending::timed_out);
  CHECK(ask("does not read").answer.ending == Ending::timed_out);
  CHECK(ask("sleeps", {300ms, 0, true}).answer.ending == Ending::timed_out);
}

TEST_CASE("a box that does not start is no crash of the stage") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  SupervisedCommand broken = command(box, "none");
  broken.words.back() = "/box/missing";
  StageProgram missing(broken);
  Frame frame;
  const Answer answer = missing.ask({"name", "text", 2, 2}, frame);
  CHECK(answer.ending == Ending::did_not_start);
  CHECK(answer.detail == ENOENT);
  StageProgram dies(SupervisedCommand{{"/bin/false"}});
  CHECK(dies.ask({"name", "text", 2, 2}, frame).ending == Ending::did_not_start);
  StageProgram nowhere(SupervisedCommand{{"/no/such/box"}});
  CHECK(nowhere.ask({"name", "text", 2, 2}, frame).ending == Ending::did_not_start);
}

TEST_CASE("after a crash in the box the next question starts the program anew") {
  FOS_NEEDS_BOX();
  const Box box = make_box();
  StageProgram program(command(box, "crashes"));
  Frame frame;
  CHECK(program.ask({"name", "text", 2, 2}, frame).ending == Ending::crashed);
  CHECK(program.ask({"name", "text", 2, 2}, frame).ending == Ending::crashed);
}
