#include "grading/box/compile.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <regex>
#include <sstream>
#include <system_error>

namespace fos::grading {
namespace {

namespace fs = std::filesystem;

constexpr const char* program_name = "program";
constexpr std::size_t most_output = 65536;

std::string contents(const fs::path& file) {
  std::ostringstream words;
  words << std::ifstream(file, std::ios::binary).rdbuf();
  return words.str();
}

/// Whether a line of it includes the header: then it may come precompiled.
bool includes_closest_hit(const std::string& source) {
  for (std::size_t at = 0; at < source.size();) {
    const std::size_t end = std::min(source.find('\n', at), source.size());
    static const std::regex include(R"(\s*#\s*include\s*["<]fos/closest_hit\.hpp[">].*)");
    const std::string line = source.substr(at, std::min<std::size_t>(end - at, 200));
    if (line.find("closest_hit.hpp") != std::string::npos && std::regex_match(line, include)) {
      return true;
    }
    at = end + 1;
  }
  return false;
}

[[noreturn]] void fail(const char* what, const fs::path& path) {
  throw fs::filesystem_error(what, path, std::error_code(errno, std::generic_category()));
}

/// The program as ours, where nobody but its box can use it. False where it is no plain file.
bool take_program(const fs::path& made, const fs::path& place, unsigned user) {
  struct stat status {};
  if (lstat(made.c_str(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_nlink != 1) {
    return false;
  }
  if (rename(made.c_str(), place.c_str()) != 0) fail("rename", place);
  if (user != 0 && lchown(place.c_str(), 0, user) != 0) fail("chown", place);
  fs::permissions(place, user != 0 ? fs::perms{0550} : fs::perms{0500});
  return true;
}

RunResult compile_once(const Workshop& workshop, const Box& box, const fs::path& folder,
                       const CompileJob& job, const std::string& source, Headers headers,
                       const std::function<void()>& on_wait) {
  fs::remove_all(folder);
  const fs::path file = folder / job.name;
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << source;
  out.close();
  if (!out) fail("write", file);
  for (fs::path place = file; place != folder; place = place.parent_path()) {
    fs::permissions(place, fs::is_directory(place) ? fs::perms{0755} : fs::perms{0444});
  }
  Errand errand = workshop.compiler_errand(job.lecture, headers, job.sanitized);
  errand.folder = folder;
  errand.words.insert(errand.words.end(), {"-o", program_name, job.name});
  const auto linking = workshop.linker_words();
  errand.words.insert(errand.words.end(), linking.begin(), linking.end());
  return run(box, errand, {.output = most_output, .cut = true}, on_wait);
}

}  // namespace

CompileResult compile(const Workshop& workshop, const Box& box, unsigned slot,
                      const CompileJob& job, const std::function<void()>& on_wait) {
  const std::string source = contents(job.source);
  const fs::path folder = workshop.slot(slot) / "compile";
  const bool both = job.lecture >= 4 && includes_closest_hit(source);
  CompileResult result;
  result.run = compile_once(workshop, box, folder, job, source,
                            both ? Headers::stage_and_closest_hit : Headers::stage, on_wait);
  if (both && !job.sanitized && result.run.ending == RunEnding::exited && result.run.status != 0) {
    // What stands in front of the include may differ; the student's own order decides.
    result.run = compile_once(workshop, box, folder, job, source, Headers::stage, on_wait);
  }
  result.output = workshop.readable(result.run.output);
  result.run.output.clear();
  switch (result.run.ending) {
    case RunEnding::exited:
      result.ending = CompileEnding::rejected;
      if (result.run.status == 0 && take_program(folder / program_name, job.program, box.user())) {
        result.ending = CompileEnding::compiled;
      }
      break;
    case RunEnding::signalled:
    case RunEnding::out_of_time:
    case RunEnding::out_of_memory:
    case RunEnding::flooded:
    case RunEnding::over_limit:
      result.ending = CompileEnding::over_limit;
      break;
    case RunEnding::infrastructure:
      break;
  }
  fs::remove_all(folder);
  return result;
}

SupervisedCommand stage_command(const Box& box, const fs::path& program, const BoxLimits& limits,
                                bool sanitized) {
  Errand errand;
  errand.words = {"/box/stage"};
  errand.shown = {{program, "/box/stage"}};
  errand.limits = limits;
  if (sanitized) {
    errand.limits.address_space = false;
    errand.environment = {
        "ASAN_OPTIONS=detect_leaks=0:hard_rss_limit_mb=" + std::to_string(limits.memory >> 20),
        "UBSAN_OPTIONS=print_stacktrace=1"};
  }
  return {box.command(errand)};
}

}  // namespace fos::grading
