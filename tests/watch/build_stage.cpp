#include "build_stage.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <sstream>
#include <system_error>

#include "check_report.hpp"
#include "child.hpp"

namespace fos {
namespace {

/// The lock of `flock build.ninja`, which ./lab takes: two builds at once would write into each
/// other's files.
class BuildLock {
 public:
  BuildLock(const std::filesystem::path& build, const std::stop_token& stop)
      : file_(open((build / "build.ninja").c_str(), O_RDONLY | O_CLOEXEC)) {
    while (file_ >= 0 && flock(file_, LOCK_EX | LOCK_NB) != 0 && !stop.stop_requested()) {
      usleep(20'000);
    }
  }
  ~BuildLock() {
    if (file_ >= 0) close(file_);
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;

 private:
  int file_;
};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t i = 0; (i = text.find(from, i)) != std::string::npos; i += to.size()) {
    text.replace(i, from.size(), to);
  }
}

}  // namespace

std::string compiler_words(const std::string& log, const std::filesystem::path& root) {
  std::istringstream in(log);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("FAILED: ")) {
      std::getline(in, line);  // the whole command
      continue;
    }
    const bool progress = line.starts_with("[") && line.find("] ") != std::string::npos;
    const bool ninja = line.starts_with("ninja: ") && !line.starts_with("ninja: error");
    if (!progress && !ninja && !line.starts_with("-- ")) out.append(line).append("\n");
  }
  replace_all(out, root.string() + "/", "");
  return out;
}

Built build_stage(const std::filesystem::path& root, const std::filesystem::path& build,
                  const Stage& stage, bool anew, const std::stop_token& stop) {
  const BuildLock lock(build, stop);
  const std::string target = "lab_" + std::string(stage.id);
  if (anew) {
    std::error_code error;  // where CMake puts it elsewhere, times have to do
    std::filesystem::remove(
        build / fmt::format("CMakeFiles/{}.dir/{}.o", target, stage_file(stage)), error);
  }
  const Heard heard = run_heard(
      {"env", "LC_ALL=C.UTF-8", "NINJA_STATUS=[%f/%t] ", "ninja", "-C", build.string(), target},
      stop);
  if (heard.status == 0) return {true, ""};
  return {false, compiler_words(heard.words, root)};
}

}  // namespace fos
