#include "stage_rungs.hpp"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <memory>

#include "fit.hpp"
#include "fos/stage_program.hpp"
#include "fos/text.hpp"

namespace fos::numerics {
namespace {

// A stage that needs longer for one small picture would need hours for the study.
constexpr std::chrono::seconds patience{5};
constexpr int small_picture = 40;  // its longer side, at most

struct Kind {
  Precision precision;
  const char* suffix;
  const char* name;
  Colors (*colors)(const SceneText&);
};
constexpr Kind kinds[] = {{Precision::binary32, "_float", "float", colors_of<float>},
                          {Precision::binary64, "", "double", colors_of<double>},
                          {Precision::extended, "_extended", "extended", colors_of<long double>}};

const Kind& kind_of(Precision precision) {
  return *std::find_if(std::begin(kinds), std::end(kinds),
                       [&](const Kind& kind) { return kind.precision == precision; });
}

std::filesystem::path program_of(const StagePrograms& programs, const Kind& kind) {
  return programs.folder / ("lab_" + std::string(programs.stage->id) + kind.suffix);
}

[[noreturn]] void fail(const std::filesystem::path& program, const Answer& answer, int height) {
  const std::string name = program.filename().string();
  const std::string rows = std::to_string(answer.rows);
  const std::string all = std::to_string(height);
  switch (answer.ending) {
    case Ending::refused:  // it has said why
      throw StageError(2, "");
    case Ending::crashed:
      throw StageError(1, say(text::trade_crashed, {name, strsignal(answer.detail), rows, all}));
    case Ending::exited:
      throw StageError(1,
                       say(text::trade_exited, {name, std::to_string(answer.detail), rows, all}));
    case Ending::timed_out:
      throw StageError(1, say(text::trade_timed_out, {name, rows, all}));
    case Ending::did_not_start:
      throw StageError(
          3, say(text::tool_did_not_start, {program.string(), std::strerror(answer.detail)}));
    default:
      throw StageError(1, say(text::trade_malformed, {name}));
  }
}

/// One program, asked for one scene again and again.
class Asked {
 public:
  Asked(std::filesystem::path path, Request request)
      : path_(std::move(path)), program_(path_, {patience * 3, 0}), request_(std::move(request)) {}

  /// Throws the rows away: what keeping them costs is not the program's.
  void ask() {
    check(program_.ask(
        request_, [](const FrameHeader&) {}, [](int, const Row&) {}));
  }

  Frame frame() {
    Frame frame;
    check(program_.ask(request_, frame));
    return frame;
  }

  /// In nanoseconds.
  double processor_time() const {
    clockid_t clock{};
    timespec time{};
    if (program_.process() < 0 || clock_getcpuclockid(program_.process(), &clock) != 0) return 0;
    clock_gettime(clock, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
  }

 private:
  void check(const Answer& answer) const {
    if (answer.ending != Ending::complete) fail(path_, answer, request_.height);
  }

  std::filesystem::path path_;
  StageProgram program_;
  Request request_;
};

/// A rung without a name yet.
Rung asking(const std::filesystem::path& path, const Request& request, const Colors& colors) {
  const auto asked = std::make_shared<Asked>(path, request);
  return {"", "", [asked] { asked->ask(); },
          [asked, colors](const Truth& truth) { return errors_of(asked->frame(), truth, colors); },
          [asked] { return asked->processor_time(); }};
}

}  // namespace

std::vector<Precision> usable_precisions(const StagePrograms& programs, const SceneText& scene,
                                         std::vector<std::string>& notes) {
  const int factor = (std::max(scene.canvas_width, scene.canvas_height) - 1) / small_picture + 1;
  const Request request = request_for(made_smaller(scene, factor));
  std::vector<Precision> usable;
  // double first: it is what the student renders with.
  for (const Precision precision :
       {Precision::binary64, Precision::binary32, Precision::extended}) {
    const Kind& kind = kind_of(precision);
    const std::filesystem::path path = program_of(programs, kind);
    StageProgram program(path, {patience, 0});
    Frame frame;
    const Answer answer = program.ask(request, frame);
    if (answer.ending == Ending::refused && precision != Precision::binary64) {
      notes.push_back(say(text::trade_refused_at, {kind.name}));
      continue;
    }
    if (answer.ending != Ending::complete) fail(path, answer, request.height);
    const auto unwritten = std::count(frame.unwritten.begin(), frame.unwritten.end(), 1);
    if (unwritten > 0) {
      throw StageError(
          1, say(text::trade_unwritten, {path.filename().string(), std::to_string(unwritten),
                                         std::to_string(frame.unwritten.size())}));
    }
    usable.push_back(precision);
  }
  std::sort(usable.begin(), usable.end());
  return usable;
}

void add_stage_rungs(std::vector<Rung>& rungs, const StagePrograms& programs,
                     const std::vector<Precision>& precisions, const SceneText& scene) {
  for (const Precision precision : precisions) {
    const Kind& kind = kind_of(precision);
    const Request request = request_for(scene);
    const Colors colors = kind.colors(scene);
    Rung toll =
        asking(programs.folder / (std::string("empty_stage") + kind.suffix), request, colors);
    toll.id = toll.name = std::string("empty_") + kind.name;
    Rung stage = asking(program_of(programs, kind), request, colors);
    stage.id = std::string("yours_") + kind.name;
    stage.name = say(text::trade_yours, {kind.name});
    stage.toll = rungs.size();
    rungs.push_back(std::move(toll));
    rungs.push_back(std::move(stage));
  }
}

}  // namespace fos::numerics
