// The red team, each in its box: what it deserves is what it gets, as far as a frame shows, and
// nothing outside has changed. (Its marks are a matter of the whole grader.)
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "catch2.hpp"
#include "fos/stage_program.hpp"
#include "grading/box/box_under_test.hpp"
#include "grading/box/workshop_under_test.hpp"

using namespace fos;
using namespace fos::grading;

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ostringstream words;
  words << std::ifstream(file, std::ios::binary).rdbuf();
  return words.str();
}

/// What `// deserves: point …` says.
std::string deserved(const std::string& source) {
  const std::string mark = "// deserves: point ";
  const std::size_t at = source.find(mark);
  REQUIRE(at != std::string::npos);
  const std::size_t from = at + mark.size();
  return source.substr(from, source.find('\n', from) - from);
}

/// Every file below a folder, and what is in it; the boxes' own folders left out.
std::map<std::string, std::size_t> picture_of(const fs::path& folder) {
  std::map<std::string, std::size_t> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (name.find("slot") != std::string::npos || name.starts_with("scratch")) continue;
    if (name.find("programs/") != std::string::npos || name.ends_with(".gch")) continue;
    files[name] = entry.is_regular_file() ? std::hash<std::string>()(contents(entry.path())) : 0;
  }
  return files;
}

/// How many processes of the box's user have a program from it.
int strangers(const Box& box) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    struct stat status {};
    if (stat(entry.path().c_str(), &status) != 0) continue;
    if (status.st_uid != (box.user() != 0 ? box.user() : geteuid())) continue;
    std::error_code gone;
    const fs::path program = fs::read_symlink(entry.path() / "exe", gone);
    const fs::path folder = program.parent_path();
    if (program == "/box/stage" || folder == workshop_under_test().programs()) ++count;
  }
  return count;
}

struct Given {
  bool whole = false;
  Frame frame;
};

Given given_by(const fs::path& source, const std::string& name) {
  Given given;
  const Box box = make_box();
  const fs::path program = workshop_under_test().programs() / name;
  const auto compiled = compile(workshop_under_test(), box, 0,
                                {source, "labs/lecture04/point.cpp", 4, false, program});
  CHECK(compiled.ending != CompileEnding::infrastructure);
  if (compiled.ending != CompileEnding::compiled) return given;
  BoxLimits limits;
  limits.cpu_seconds = 3;
  limits.idle_seconds = 3;
  limits.memory = 512 << 20;
  const std::string scene = contents(FOS_SOURCE_FOLDER "/labs/scenes/lecture.scene");
  StageProgram stage(stage_command(box, program, limits), {std::chrono::minutes(5), 0, true, true});
  const Answer answer = stage.ask({"lecture", scene, 60, 60}, given.frame);
  CHECK(answer.ending != Ending::did_not_start);
  given.whole = answer.ending == Ending::complete;
  stage.end();
  CHECK(strangers(box) == 0);
  return given;
}

}  // namespace

TEST_CASE("the red team gets what it deserves, and changes nothing") {
  FOS_NEEDS_BOX();
  const Given right = given_by(FOS_SOURCE_FOLDER "/solutions/lecture04/point.cpp", "right");
  REQUIRE(right.whole);
  // The secret is not there for the pictures only: it may neither be read nor changed.
  REQUIRE(contents(secret_file()) == "the reference\n");
  const auto before = picture_of(test_folder());
  int count = 0;
  for (const auto& entry : fs::directory_iterator(FOS_SOURCE_FOLDER "/tests/grading/red_team")) {
    if (!entry.is_directory()) continue;
    ++count;
    const std::string name = entry.path().filename().string();
    INFO(name);
    const fs::path source = entry.path() / "point.cpp";
    const std::string deserves = deserved(contents(source));
    const Given given = given_by(source, name);
    const bool same = given.whole && given.frame.channels == right.frame.channels;
    if (deserves == "full") CHECK(same);
    const bool in_part = deserves.starts_with("in_part ");
    if (deserves == "nothing" || in_part) CHECK_FALSE(same);
    CHECK((deserves == "full" || deserves == "nothing" || in_part ||
           deserves.starts_with("at_most ")));
    CHECK(picture_of(test_folder()) == before);
    CHECK_FALSE(fs::exists("/tmp/late"));
  }
  CHECK(count >= 25);
}
