// `fos_grade --root TREE --build FOLDER PATH --output DIR [option…]`: what `./lab grade` does.
//
// Exit status: 0 all is graded, 2 wrong usage or input, 3 the toolkit's own trouble: no box, a full
// disk, or a submission that could not be judged; 130 interrupted.
#include <fmt/core.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>

#include "class_run.hpp"
#include "equipment.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "grade_options.hpp"
#include "grading/intake/csv.hpp"
#include "grading/intake/file_names.hpp"
#include "grading/intake/intake.hpp"
#include "grading/intake/journal.hpp"
#include "grading/intake/overrides.hpp"
#include "grading/intake/result_json.hpp"
#include "grading/intake/result_key.hpp"
#include "grading/intake/roster.hpp"
#include "merge.hpp"
#include "toolkit_version.hpp"

namespace {

using namespace fos;
using namespace fos::grading;
namespace fs = std::filesystem;

std::atomic<bool> interrupted{false};

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm parts{};
  localtime_r(&time, &parts);
  char text[40];
  const std::size_t length = std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%S%z", &parts);
  return {text, length};
}

/// The last run in this folder, if there was one.
std::optional<Run> run_before(const GradeOptions& options) {
  try {
    std::ifstream in(options.output / "run.json");
    const std::string json{std::istreambuf_iterator<char>(in), {}};
    if (!json.empty()) return run_from_json(json);
  } catch (const JsonError&) {  // NOLINT(bugprone-empty-catch): then none
  }
  return std::nullopt;
}

/// Each hand-in of this part, with its student and its instructor's marks; its key is not known
/// yet.
std::vector<Entry> entries_of(const ClassFiles& hand_ins, const GradeOptions& options) {
  std::vector<Whose> people;
  people.reserve(hand_ins.size());
  for (std::size_t i = 0; i < hand_ins.size(); ++i) people.push_back(hand_ins.whose(i));
  if (!options.roster.empty()) {
    for (const std::string& line : match(read_roster(options.roster), people).words) {
      std::cerr << line << '\n';
    }
  }
  Overrides overrides;
  if (!options.overrides.empty()) {
    overrides = read_overrides(options.overrides, stages);
    check_overrides(overrides, people);
  }
  std::vector<Entry> entries;
  entries.reserve(people.size() / options.parts + 1);
  for (std::size_t i = options.part - 1; i < people.size(); i += options.parts) {
    entries.push_back({people[i], "", overrides_of(overrides, people[i]), i});
  }
  return entries;
}

/// What a result hangs on besides the files, the seed and the toolkit.
std::string settings_of(const GradeOptions& options, const Shares& shares) {
  std::string words;
  for (const Stage* stage : options.stages) words += std::string(stage->id) + ' ';
  return words + fmt::format("{} {} {}", shares.checks, shares.scenes, shares.relations);
}

int status_of(std::size_t not_judged) {
  if (not_judged == 0) return 0;
  std::cerr << say(text::grade_not_judged, {std::to_string(not_judged)}) << '\n';
  return 3;
}

/// The results in the class would be somebody's hand-in next time.
void check_place(const GradeOptions& options) {
  if (options.list || !std::filesystem::is_directory(options.path)) return;
  const auto inside = std::filesystem::weakly_canonical(options.output)
                          .lexically_relative(std::filesystem::canonical(options.path));
  if (inside.empty() || *inside.begin() == "..") return;
  throw UsageError(say(text::grade_output_inside, {shown_path(options.output.string())}));
}

int grade(const GradeOptions& options) {
  check_place(options);
  const ClassFiles hand_ins = read_class(options.path, stages, options.one);
  std::cerr << hand_ins.words() << '\n';
  for (const std::string& note : hand_ins.notes()) std::cerr << note << '\n';
  if (options.list) {
    for (std::size_t i = 0; i < hand_ins.size(); ++i) {
      const Whose& whose = hand_ins.whose(i);
      std::cout << whose.id << '\t' << shown_path(whose.source) << '\n';
    }
    return 0;
  }
  std::vector<Entry> entries = entries_of(hand_ins, options);

  Journal journal(options.output);
  journal.load();
  for (const std::string& damaged : journal.damaged()) {
    std::cerr << say(text::grade_damaged, {damaged}) << '\n';
  }
  const std::optional<Run> before = run_before(options);
  const Shares shares{FOS_SHARES};
  Run run;
  run.title = fs::absolute(options.path / ".").parent_path().filename().string();
  run.toolkit = toolkit_version(options.root, options.build);
  run.seed = options.seed ? *options.seed
             : before     ? before->seed
                          : std::random_device()() & 0xFFFFFFFFU;
  run.feedback = options.feedback;
  run.date = now();
  run.part = options.part;
  run.parts = options.parts;
  const std::string settings = settings_of(options, shares);
  for (Entry& entry : entries) {
    entry.key = result_key(hand_ins.read(entry.place), run.seed, run.toolkit, settings);
  }
  Tally tally;
  if (before && all_finished(entries, journal)) {
    run.box = before->box;
    tally.finished_before = entries.size();
  } else {
    const Equipment equipment(options, shares, run.seed);
    run.box = name(equipment.course().box.level);
    write_whole_file(options.output / "run.json", to_json(run));
    const ClassRun class_run(equipment.course(), options, run, equipment.scratch());
    tally = class_run.grade(hand_ins, entries, journal, interrupted);
  }
  for (const std::string& refused : report_class(options, run, entries, journal)) {
    std::cerr << refused << '\n';
  }
  run.is_finished = true;
  run.finished.reserve(entries.size());
  for (const Entry& entry : entries) run.finished.push_back(entry.whose.id);
  write_whole_file(options.output / "run.json", to_json(run));
  std::cout << say(text::grade_done,
                   {std::to_string(tally.graded), std::to_string(tally.finished_before),
                    std::to_string(run.seed), (options.output / "index.html").string()})
            << '\n';
  return status_of(tally.not_judged);
}

int merge(const GradeOptions& options) {
  const Merged merged = merge_parts(options);
  for (const std::string& refused : merged.refused) std::cerr << refused << '\n';
  std::cout << say(text::grade_merged,
                   {std::to_string(merged.results), std::to_string(options.merged.size()),
                    (options.output / "index.html").string()})
            << '\n';
  return status_of(merged.not_judged);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { interrupted = true; });
  std::signal(SIGTERM, [](int) { interrupted = true; });
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const GradeOptions options = parse_grade_options({argv + 1, argv + argc});
    return options.merged.empty() ? grade(options) : merge(options);
  } catch (const UsageError& error) {
    std::cerr << "lab: " << error.what() << '\n';
    return 2;
  } catch (const IntakeError& error) {
    std::cerr << "lab: " << error.what() << '\n';
    return error.exit_status;
  } catch (const TableError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const FileError& error) {
    std::cerr << "lab: " << error.what() << '\n';
    return error.exit_status;
  } catch (const Interrupted&) {
    std::cerr << say(text::grade_interrupted) << '\n';
    return 130;
  } catch (const std::exception& error) {
    std::cerr << say(text::tool_error) << ": " << error.what() << '\n';
    return 3;
  }
}
