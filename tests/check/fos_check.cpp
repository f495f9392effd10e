// `fos_check [--overview] --images FOLDER --picture PROGRAM STAGE=PROGRAM…`: what ./lab check says.
// STAGE=!FILE is a stage that does not build; FILE has what the compiler said.
//
// Exit status: 0 every stage passes, 1 not, 2 wrong usage, 3 the toolkit's own trouble.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "advice.hpp"
#include "check_report.hpp"
#include "comparison.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "picture_of_check.hpp"
#include "preview.hpp"

namespace {

using namespace fos;

struct Job {
  const Stage* stage = nullptr;
  std::string program;
  std::string log;  ///< where the stage does not build
};

struct Options {
  bool overview = false;
  std::filesystem::path images;
  std::filesystem::path picture_program;
  std::vector<Job> jobs;
};

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// As one word for a shell, and as short as can be from here.
std::string quoted(const std::filesystem::path& path) {
  const std::filesystem::path from_here = path.lexically_proximate(std::filesystem::current_path());
  const bool below = !from_here.empty() && *from_here.begin() != "..";
  const std::string word = (below ? from_here : path).string();
  return word.find(' ') == std::string::npos ? word : "'" + word + "'";
}

Job parse_job(const std::string& argument) {
  const std::size_t equals = argument.find('=');
  const auto stage = std::find_if(std::begin(stages), std::end(stages), [&](const Stage& each) {
    return each.id == argument.substr(0, equals);
  });
  if (equals == std::string::npos || stage == std::end(stages)) throw UsageError(argument);
  const std::string value = argument.substr(equals + 1);
  if (value.starts_with('!')) return {stage, "", value.substr(1)};
  return {stage, value, ""};
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const bool has_value = argument == "--images" || argument == "--picture";
    if (has_value && i + 1 == arguments.size()) throw UsageError(argument);
    if (argument == "--overview") {
      options.overview = true;
    } else if (argument == "--images") {
      options.images = arguments[++i];
    } else if (argument == "--picture") {
      options.picture_program = arguments[++i];
    } else {
      options.jobs.push_back(parse_job(argument));
    }
  }
  if (options.jobs.empty() || options.images.empty()) throw UsageError("");
  return options;
}

/// How to see the pixel worked out. A scene that is no file yet becomes one.
std::string explain_line(const Options& options, const Stage& stage, const Spot& spot) {
  std::string scene;
  if (!spot.scene_text.empty()) {
    const auto path = options.images / (std::string(stage.id) + "-check.scene");
    write_whole_file(path, spot.scene_text);
    scene = " --scene " + quoted(path);
  }
  return say(text::check_explain) + "\n" +
         fmt::format("  ./lab explain {} {} {}{}\n", stage.id, spot.pixel.column, spot.pixel.row,
                     scene);
}

/// A stage in full. The picture comes last: it alone takes longer than all the rest.
bool check_one(const Options& options, const Job& job, const Paint& paint) {
  if (job.program.empty()) {
    std::cout << paint.bold(job.stage->id) << " · " << say(job.stage->name) << '\n'
              << "  " << paint.red("✗") << ' ' << say(text::check_does_not_build) << "\n\n";
    return false;
  }
  const Findings findings = examine(*job.stage, job.program, patient_limits());
  std::cout << describe(findings, paint);
  std::vector<Panel> panels;
  if (findings.shown && !findings.shown->verdict.passes()) {
    panels = compare(*findings.shown->judge, *findings.shown->frame);
  }
  if (is_terminal() && findings.shown) {
    std::cout << '\n'
              << preview(panels.empty() ? std::vector<Panel>{{say(text::check_yours),
                                                              to_bitmap(*findings.shown->frame)}}
                                        : panels,
                         24, paint.colors());
  }
  if (first_failure(findings) != nullptr) {
    const Advice advice = advise(*job.stage, job.program, patient_limits());
    if (!advice.words.empty()) std::cout << '\n' << advice.words;
  }
  std::cout << '\n' << next_step(findings) << std::flush;
  if (const Finding* first = first_failure(findings); first != nullptr && first->spot) {
    std::cout << explain_line(options, *job.stage, *first->spot) << std::flush;
  }
  if (!panels.empty()) {
    const auto path = options.images / (std::string(job.stage->id) + "-check.png");
    if (write_picture(options.picture_program, path, panels)) {
      std::cout << say(text::check_picture, {quoted(path)}) << '\n';
    }
  }
  return findings.passes();
}

bool check_all(const Options& options, const Paint& paint) {
  std::vector<StageResult> results;
  for (const Job& job : options.jobs) {
    StageResult result{job.stage, std::nullopt, ""};
    if (!job.program.empty()) {
      result.findings = examine(*job.stage, job.program, patient_limits());
      if (first_failure(*result.findings) != nullptr) {
        result.mistake = advise(*job.stage, job.program, patient_limits()).mistake;
      }
    }
    results.push_back(std::move(result));
  }
  std::cout << overview(results, paint);
  return std::all_of(results.begin(), results.end(), [](const StageResult& result) {
    return result.findings && result.findings->passes();
  });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = parse({argv + 1, argv + argc});
    const Paint paint(colors_of_output());
    if (options.overview) return check_all(options, paint) ? 0 : 1;
    bool all = true;
    for (const Job& job : options.jobs) {
      if (&job != &options.jobs.front()) std::cout << '\n';
      all = check_one(options, job, paint) && all;
    }
    return all ? 0 : 1;
  } catch (const UsageError& error) {
    std::cerr << "fos_check: " << say(text::check_usage, {error.what()}) << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << say(text::tool_error) << ": " << error.what() << '\n';
    return 3;
  }
}
