#include "grading/box/probe.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fos/text.hpp"
#include "grading/box/inside/child.hpp"
#include "grading/box/inside/trials.hpp"
#include "grading/box/run.hpp"

namespace fos::grading {
namespace {

std::string first_line(const std::string& words) { return words.substr(0, words.find('\n')); }

/// Why the trial did not even start.
std::string not_started(Level level, const RunResult& result) {
  const auto step = static_cast<inside::Step>(result.step);
  if (step == inside::Step::landlock && (result.status == ENOSYS || result.status == EOPNOTSUPP)) {
    return say(text::box_no_landlock);
  }
  if (step == inside::Step::filter) return say(text::box_no_filter);
  if (level == Level::bubblewrap && !std::filesystem::exists(bubblewrap_program)) {
    return say(text::box_not_installed);
  }
  const std::string said = first_line(result.output);
  return say(text::box_refused_here,
             {!said.empty() ? said : std::string(std::strerror(result.status))});
}

/// Why the level does not hold here; empty if it does.
std::string flaw(const ProbeSetting& setting, Level level) {
  if (level == Level::uid && geteuid() != 0) return say(text::box_only_root);
  BoxSetting with_level = setting.box;
  with_level.level = level;
  const Box box(with_level, 0, setting.scratch);
  Errand errand;
  errand.words = {"/box/trial", "try-all"};
  errand.shown = {{setting.box.inside, "/box/trial"}};
  for (const auto& secret : setting.secrets) errand.words.push_back(secret.string());
  errand.words.insert(errand.words.end(),
                      {"--", std::to_string(getpid()), std::to_string(getppid())});
  const RunResult result = run(box, errand);
  if (result.ending == RunEnding::infrastructure) return not_started(level, result);
  if (result.ending == RunEnding::exited && level != Level::none) {
    switch (result.status) {
      case inside::read_a_secret:
        return say(text::box_reads_secrets, {first_line(result.output)});
      case inside::wrote_outside:
        return say(text::box_writes_outside);
      case inside::reached_a_process:
        return say(text::box_reaches_processes);
      case inside::opened_a_socket:
        return say(text::box_reaches_network);
      default:
        break;
    }
  }
  if (result.succeeded() || (level == Level::none && result.ending == RunEnding::exited)) return "";
  return say(text::box_refused_here, {first_line(result.output)});
}

}  // namespace

ProbeResult probe(const ProbeSetting& setting) {
  ProbeResult result;
  for (const Level level : levels) {
    if (setting.only && level != *setting.only) continue;
    const std::string why =
        level == Level::none && !setting.unsafe ? say(text::box_unsafe_only) : flaw(setting, level);
    if (why.empty()) {
      result.level = level;
      break;
    }
    result.not_had.push_back({level, why});
  }
  return result;
}

}  // namespace fos::grading
