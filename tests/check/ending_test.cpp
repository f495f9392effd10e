// Stages that end in mid-frame: how, and at which pixel, is known from outside.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>

#include "asked.hpp"
#include "catch2.hpp"
#include "fos/text.hpp"
#include "report.hpp"

using namespace fos;

namespace {

constexpr int width = 4;
constexpr int height = 3;

SceneText scene() { return parse_scene_text("canvas_size = 4 x 3", "scene"); }

struct Ended {
  Answer answer;
  std::string printed;
};

/// `frames` asked of one program that ends at `pixel`; the last answer.
Ended ask(const char* ending, int pixel, Limits limits, int frames = 1) {
  setenv("FOS_ENDING", ending, 1);
  setenv("FOS_AT", std::to_string(pixel).c_str(), 1);
  StageProgram program(FOS_ENDING_PROGRAM, limits);
  Ended ended;
  for (int i = 0; i < frames; ++i) {
    Frame frame;
    ended = {program.ask(request_for(scene()), frame), program.words()};
  }
  return ended;
}

constexpr Limits lasting{std::chrono::seconds(30), 1, true, false};
constexpr Limits fresh{std::chrono::seconds(30), 1, true, true};

}  // namespace

TEST_CASE("a stage that crashes says at which pixel") {
  const auto [ending, signal] = GENERATE(table<const char*, int>(
      {{"null", SIGSEGV}, {"recursion", SIGSEGV}, {"division", SIGFPE}, {"abort", SIGABRT}}));
  for (const Limits& limits : {lasting, fresh}) {
    INFO(ending << (limits.fresh ? ", fresh" : ""));
    const Answer answer = ask(ending, width + 2, limits).answer;
    CHECK(answer.ending == Ending::crashed);
    CHECK(answer.detail == signal);
    CHECK(answer.rows == 1);
    CHECK(answer.pixels == 2);
  }
}

TEST_CASE("so does one that never ends, by its processor time or by the clock") {
  for (const bool anew : {false, true}) {
    for (const char* ending : {"loop", "sleep"}) {
      INFO(ending << (anew ? ", fresh" : ""));
      const bool slow = std::string(ending) == "sleep";
      const Answer answer =
          ask(ending, 2 * width + 3,
              {slow ? std::chrono::milliseconds(300) : std::chrono::seconds(30), 1, true, anew})
              .answer;
      CHECK(answer.ending == Ending::timed_out);
      CHECK(answer.rows == 2);
      CHECK(answer.pixels == 3);
    }
  }
}

TEST_CASE("and one that leaves by itself, whose words are kept") {
  for (const Limits& limits : {lasting, fresh}) {
    const Answer left = ask("exit", 1, limits).answer;
    CHECK(left.ending == Ending::exited);
    CHECK(left.detail == 0);
    CHECK(left.rows == 0);
    CHECK(left.pixels == 1);

    const Ended thrown = ask("throw", width, limits);
    CHECK(thrown.answer.ending == Ending::exited);
    CHECK(thrown.answer.rows == 1);
    CHECK(thrown.answer.pixels == 0);
    CHECK_THAT(thrown.printed, ContainsSubstring("no idea what to do"));
  }
}

TEST_CASE("a fresh answer knows nothing of the one before") {
  const int second_frame = width * height + 1;
  CHECK(ask("abort", second_frame, lasting, 2).answer.ending == Ending::crashed);
  CHECK(ask("abort", second_frame, fresh, 2).answer.ending == Ending::complete);
}

TEST_CASE("nobody is asked any more once one has never answered") {
  setenv("FOS_ENDING", "sleep", 1);
  setenv("FOS_AT", "0", 1);
  const std::vector<SceneText> scenes(50, scene());
  int asked = 0;
  const Limits limits{std::chrono::milliseconds(300), 1, true, true};
  for (const Asked& each : ask_all(FOS_ENDING_PROGRAM, limits, scenes)) asked += each.asked ? 1 : 0;
  CHECK(asked > 0);
  CHECK(asked < 50);
}

TEST_CASE("an ending is said with its place, and what a crash means") {
  const std::string words =
      describe(Answer{Ending::crashed, SIGFPE, {}, 7, 5}, "the lecture's scene");
  CHECK_THAT(words, ContainsSubstring("column 5, row 7"));
  CHECK_THAT(words, ContainsSubstring("divided by 0"));
}
