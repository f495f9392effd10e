// fos_trade: speed against accuracy, measured. `./lab trade` calls it.
//   fos_trade --scene F [--csv F] [--plot F] [--stage ID --programs FOLDER]
#include <getopt.h>

#include <algorithm>
#include <iostream>

#include "fit.hpp"
#include "fos/progress.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "machine.hpp"
#include "oracle.hpp"
#include "plot.hpp"
#include "simd.hpp"
#include "stage_rungs.hpp"
#include "study.hpp"
#include "table.hpp"
#ifdef FOS_HAS_SOLUTION
#include "solution_rung.hpp"
#endif

namespace {

using namespace fos;
using namespace fos::numerics;

struct Options {
  std::filesystem::path scene;
  std::filesystem::path csv;
  std::filesystem::path plot;
  std::optional<StagePrograms> stage;
};

/// A wrong command line, in words.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

const Stage* find_stage(std::string_view id) {
  const auto stage = std::find_if(std::begin(stages), std::end(stages),
                                  [&](const Stage& each) { return each.id == id; });
  if (stage == std::end(stages)) throw UsageError(say(text::tool_usage));
  return stage;
}

Options parse_options(int argc, char** argv) {
  Options options;
  std::string stage;
  std::filesystem::path programs;
  const option known[] = {
      {"scene", required_argument, nullptr, 's'},    {"csv", required_argument, nullptr, 'c'},
      {"plot", required_argument, nullptr, 'p'},     {"stage", required_argument, nullptr, 'g'},
      {"programs", required_argument, nullptr, 'f'}, {}};
  for (int which = 0; (which = getopt_long(argc, argv, "", known, nullptr)) != -1;) {
    switch (which) {
      case 's':
        options.scene = optarg;
        break;
      case 'c':
        options.csv = optarg;
        break;
      case 'p':
        options.plot = optarg;
        break;
      case 'g':
        stage = optarg;
        break;
      case 'f':
        programs = optarg;
        break;
      default:
        throw UsageError(say(text::tool_usage));
    }
  }
  const bool usable = optind == argc && !options.scene.empty() && stage.empty() == programs.empty();
  if (!usable) throw UsageError(say(text::tool_usage));
  if (!stage.empty()) options.stage = StagePrograms{find_stage(stage), programs};
  return options;
}

/// Before minutes are spent: whether the files can be made at all.
void check_outputs(const Options& options) {
  if (!options.plot.empty()) plot_format(options.plot);
  for (const std::filesystem::path& path : {options.csv, options.plot}) {
    if (!path.empty()) const WholeFile trial(path);
  }
}

/// All that is measured on one canvas. `read` is the scene as its file has it, but for the canvas.
class Ladder {
 public:
  Ladder(const Options& options, const SceneText& read) : options_(options), read_(read) {
    if (options.stage) precisions_ = usable_precisions(*options.stage, read, notes);
#ifndef __SSE__
    notes.push_back(say(text::trade_no_rsqrt));
#endif
#ifdef FOS_HAS_SOLUTION
    try {
      solution_rung(made_smaller(seen(), max_canvas));
    } catch (const SceneError&) {
      has_solution_ = false;
      notes.push_back(say(text::trade_no_solution));
    }
#endif
  }

  /// The scene whose light all rungs compute.
  SceneText seen() const {
    return options_.stage ? as_seen_by(read_, options_.stage->stage->terms) : read_;
  }

  std::vector<Rung> rungs(const SceneText& seen_on_canvas) const {
    std::vector<Rung> rungs = ladder(seen_on_canvas);
#ifdef FOS_HAS_SOLUTION
    if (has_solution_) rungs.push_back(solution_rung(seen_on_canvas));
#endif
    if (options_.stage) {
      SceneText read = read_;
      read.canvas_width = seen_on_canvas.canvas_width;
      read.canvas_height = seen_on_canvas.canvas_height;
      add_stage_rungs(rungs, *options_.stage, precisions_, read);
    }
    return rungs;
  }

  std::vector<std::string> notes;  ///< what is left out, in words

 private:
  const Options& options_;
  const SceneText& read_;
  std::vector<Precision> precisions_;
  [[maybe_unused]] bool has_solution_ = true;
};

Study run_study(const Options& options, const SceneText& scene) {
  const Ladder ladder(options, scene);
  const SceneText seen = ladder.seen();
  const auto rungs_of = [&](const SceneText& canvas) { return ladder.rungs(canvas); };
  const Fit fit = numerics::fit(seen, cost_of(seen, rungs_of));
  const SceneText canvas = made_smaller(seen, fit.factor);

  // Progress in milliseconds, as expected.
  const auto milliseconds = [](double seconds) { return static_cast<long>(1000 * seconds); };
  Truth truth;
  {
    Progress progress(say(text::trade_progress_truth), milliseconds(fit.truth_seconds) + 1);
    truth = truth_of(canvas, [&](int rows) {
      progress.update(milliseconds(fit.truth_seconds * rows / canvas.canvas_height));
    });
  }
  const std::vector<Rung> rungs = ladder.rungs(canvas);
  Pace pace;
  pace.budget = std::chrono::milliseconds(milliseconds(seconds_for_rounds));
  std::vector<Times> times;
  {
    Progress progress(say(text::trade_progress_rounds), 1000);
    times = measure(rungs, truth.pixels.size(), pace,
                    [&](double done) { progress.update(static_cast<long>(1000 * done)); });
  }

  Study study;
  study.rows = rows_of(rungs, times, truth);
  study.scene = std::filesystem::path(scene.name).filename().string();
  if (options.stage) study.stage = say(options.stage->stage->name);
  study.width = canvas.canvas_width;
  study.height = canvas.canvas_height;
  study.own_width = scene.canvas_width;
  study.own_height = scene.canvas_height;
  study.factor = fit.factor;
  study.rounds = static_cast<int>(times.front().size());
  study.processor = processor_name();
  study.compiler = compiler_name();
  study.simd = simd_target();
  study.notes = ladder.notes;
  return study;
}

int trade(int argc, char** argv) {
  const Options options = parse_options(argc, argv);
  check_outputs(options);
  const SceneText scene = read_scene_text(options.scene);
  for (const std::string& warning : scene_warnings(scene)) std::cerr << warning << '\n';
  const Study study = run_study(options, scene);
  std::cout << table_of(study) << std::flush;
  if (!options.csv.empty()) write_whole_file(options.csv, csv_of(study));
  if (!options.plot.empty()) draw(plot_script(study, plot_format(options.plot)), options.plot);
  return 0;
}

/// Says what went wrong, where that was not said yet.
int failed(int status, const std::string& message) {
  if (!message.empty()) std::cerr << say(text::tool_error) << ": " << message << '\n';
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return trade(argc, argv);
  } catch (const UsageError& error) {
    return failed(2, error.what());
  } catch (const std::invalid_argument& error) {  // a plot of no known format
    return failed(2, error.what());
  } catch (const SceneError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::range_error& error) {  // numbers that exact arithmetic is not made for
    return failed(2, say(text::trade_too_extreme, {error.what()}));
  } catch (const reference::UndecidedError& error) {
    return failed(2, say(text::trade_too_extreme, {error.what()}));
  } catch (const StageError& error) {
    return failed(error.exit_status, error.what());
  } catch (const FileError& error) {
    return failed(error.exit_status, error.what());
  } catch (const std::exception& error) {
    return failed(3, error.what());
  }
}
