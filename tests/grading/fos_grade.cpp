// `fos_grade --root TREE --build FOLDER PATH --output DIR [option…]`: what `./lab grade` does.
//
// Exit status: 0 all is graded, 2 wrong usage or input, 3 the toolkit's own trouble: no box, a full
// disk, or a submission that could not be judged; 130 interrupted.
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "class_run.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "grade_options.hpp"
#include "grading/box/probe.hpp"
#include "grading/box/workshop.hpp"
#include "grading/intake/class_files.hpp"
#include "grading/intake/journal.hpp"
#include "grading/intake/result_json.hpp"
#include "grading/intake/result_key.hpp"
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

/// The seed that was asked for, that of an earlier run in this folder, or a new one.
std::uint64_t seed_of(const GradeOptions& options) {
  if (options.seed) return *options.seed;
  try {
    std::ifstream in(options.output / "run.json");
    const std::string json{std::istreambuf_iterator<char>(in), {}};
    if (!json.empty()) return run_from_json(json).seed;
  } catch (const JsonError&) {  // NOLINT(bugprone-empty-catch): then a new one
  }
  return std::random_device()() & 0xFFFFFFFFU;
}

/// A folder for this run where the box's users can come, gone at its end.
class WorkFolder {
 public:
  WorkFolder() : path_((fs::temp_directory_path() / "fos-grade-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr)
      throw FileError(3, say(text::grade_no_work_folder, {path_}));
    fs::permissions(path_, fs::perms(0711));
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  fs::path path() const { return path_; }

 private:
  std::string path_;
};

/// The strongest box that holds here, said in words.
BoxSetting find_box(const GradeOptions& options, const Workshop& workshop,
                    const fs::path& scratch) {
  ProbeSetting setting;
  setting.box.inside = workshop.inside();
  setting.box.compiler = this_build().compiler;
  setting.scratch = scratch;
  setting.secrets = {options.root / "solutions", options.root / "tests", fs::absolute(options.path),
                     fs::absolute(options.output)};
  setting.only = options.box;
  setting.unsafe = options.unsafe;
  const ProbeResult found = probe(setting);
  for (const NotHad& each : found.not_had) {
    std::cerr << say(text::grade_box_not_had, {name(each.level), each.why}) << '\n';
  }
  if (!found.level) throw FileError(3, say(text::grade_no_box));
  std::cerr << say(text::grade_box, {name(*found.level)}) << '\n';
  setting.box.level = *found.level;
  return setting.box;
}

int grade(const GradeOptions& options) {
  const ClassFiles hand_ins = read_class(options.path, stages);
  std::cerr << hand_ins.words() << '\n';
  for (const std::string& note : hand_ins.notes()) std::cerr << note << '\n';

  Journal journal(options.output);
  journal.load();
  for (const std::string& damaged : journal.damaged()) {
    std::cerr << say(text::grade_damaged, {damaged}) << '\n';
  }
  const WorkFolder work;
  Workshop workshop(this_build(), work.path() / "workshop");
  Course course;
  course.box = find_box(options, workshop, work.path() / "probe");
  course.workshop = &workshop;
  course.picture_program = options.build / "bin" / "fos_picture";
  course.seed = seed_of(options);
  workshop.precompile(Box(course.box, 0, work.path() / "precompile"));
  const DrawnScenes drawn(course.seed);
  std::string settings;
  for (const Stage* stage : options.stages) {
    course.stages.emplace_back(*stage, drawn);
    settings += std::string(stage->id) + ' ';
  }
  settings += name(options.feedback);

  const Run run{options.path.filename().string(),
                toolkit_version(options.root, options.build),
                course.seed,
                std::string(name(course.box.level)),
                options.feedback,
                now()};
  write_whole_file(options.output / "run.json", to_json(run));
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < hand_ins.size(); ++i) {
    keys.push_back(result_key(hand_ins.read(i), run.seed, run.toolkit, settings));
  }
  const Tally tally =
      grade_class(hand_ins, keys, course, journal, options, run, work.path(), interrupted);

  std::vector<Summary> all;
  for (std::size_t i = 0; i < hand_ins.size(); ++i) {
    if (const auto result = journal.read(hand_ins.whose(i).id)) all.push_back(summarize(*result));
  }
  for (const std::string& refused :
       write_class_files(options.output, run, all, {options.formats})) {
    std::cerr << refused << '\n';
  }
  std::cout << say(text::grade_done,
                   {std::to_string(tally.graded), std::to_string(tally.finished_before),
                    std::to_string(run.seed), (options.output / "index.html").string()})
            << '\n';
  if (tally.not_judged == 0) return 0;
  std::cerr << say(text::grade_not_judged, {std::to_string(tally.not_judged)}) << '\n';
  return 3;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { interrupted = true; });
  std::signal(SIGTERM, [](int) { interrupted = true; });
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return grade(parse_grade_options({argv + 1, argv + argc}));
  } catch (const UsageError& error) {
    std::cerr << "lab: " << error.what() << '\n';
    return 2;
  } catch (const IntakeError& error) {
    std::cerr << "lab: " << error.what() << '\n';
    return error.exit_status;
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
