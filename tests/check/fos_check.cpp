// `fos_check [--overview] --root TREE --images FOLDER --picture PROGRAM STAGE=PROGRAM…`: what ./lab
// check says. STAGE=!FILE is a stage that does not build; FILE has what the compiler said.
//
// Exit status: 0 every stage passes, 1 not, 2 wrong usage, 3 the toolkit's own trouble.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "advice.hpp"
#include "check_screen.hpp"
#include "compile_error.hpp"
#include "fos/text.hpp"
#include "picture_maker.hpp"

namespace {

using namespace fos;

struct Job {
  const Stage* stage = nullptr;
  std::string program;
  std::string log;  ///< where the stage does not build
};

struct Options {
  bool overview = false;
  std::filesystem::path root;  ///< where labs/ is
  std::filesystem::path images;
  std::filesystem::path picture_program;
  std::vector<Job> jobs;
};

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

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
    const bool has_value =
        argument == "--root" || argument == "--images" || argument == "--picture";
    if (has_value && i + 1 == arguments.size()) throw UsageError(argument);
    if (argument == "--overview") {
      options.overview = true;
    } else if (argument == "--root") {
      options.root = arguments[++i];
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

/// A stage in full. The picture comes last: it alone takes longer than all the rest, and a check
/// that passes never waits for it.
bool check_one(const Options& options, const Job& job, const Paint& paint) {
  if (job.program.empty()) {
    std::ifstream log(job.log);
    const std::string output{std::istreambuf_iterator<char>(log), {}};
    const std::string file = stage_file(*job.stage);
    std::cout << check_screen(*job.stage, describe_compile_error(output, options.root / file, file),
                              paint);
    return false;
  }
  const Findings findings = examine(Questions(*job.stage), job.program, patient_limits());
  std::optional<PictureMaker> maker;
  if (findings.shown && !findings.shown->verdict.passes()) maker.emplace(options.picture_program);
  const std::vector<Panel> panels = panels_of(findings, difference_of(findings));
  const std::string advice = first_failure(findings) == nullptr
                                 ? ""
                                 : advise(*job.stage, job.program, patient_limits()).words;
  std::cout << check_screen(findings, advice, panels, options.images, paint,
                            {is_terminal(), terminal_width, 0})
            << std::flush;
  if (panels.empty()) return findings.passes();
  const auto path = picture_path(*job.stage, options.images);
  if (maker->make({path, panels, check_panel_size})) {
    std::cout << picture_line(path);
  } else {
    std::cerr << maker->error() << '\n';
  }
  return findings.passes();
}

bool check_all(const Options& options, const Paint& paint) {
  std::vector<StageResult> results;
  for (const Job& job : options.jobs) {
    StageResult result{job.stage, std::nullopt, ""};
    if (!job.program.empty()) {
      result.findings = examine(Questions(*job.stage), job.program, patient_limits());
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
