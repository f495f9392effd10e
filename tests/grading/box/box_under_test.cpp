#include "grading/box/box_under_test.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "grading/box/workshop_under_test.hpp"

namespace fos::grading {

namespace fs = std::filesystem;

const fs::path& test_folder() {
  struct Folder {
    fs::path path = fs::temp_directory_path() / ("fos-box-test-" + std::to_string(getpid()));
    Folder() {
      fs::create_directories(path);
      fs::permissions(path, fs::perms{0711});
    }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

const fs::path& secret_file() {
  static const fs::path file = [] {
    // Anyone may read it, so that it is the box that keeps it; where there is only a user of its
    // own, that is what keeps it.
    fs::path path = test_folder() / "secret";
    std::ofstream(path) << "the reference\n";
    const char* level = std::getenv("FOS_BOX_LEVEL");
    const bool by_user = level != nullptr && std::string(level) == "uid";
    fs::permissions(path, by_user ? fs::perms{0600} : fs::perms{0666});
    return path;
  }();
  return file;
}

const std::optional<BoxSetting>& box_under_test() {
  static const std::optional<BoxSetting> box = []() -> std::optional<BoxSetting> {
    ProbeSetting setting;
    const fs::path inside = test_folder() / "inside";
    fs::copy_file(FOS_BOX_INSIDE, inside, fs::copy_options::overwrite_existing);
    setting.box.inside = inside;
    setting.box.compiler = fs::canonical(FOS_CXX);
    if (const char* abi = std::getenv("FOS_BOX_LANDLOCK_ABI")) {
      setting.box.landlock_abi = std::atoi(abi);
    }
    setting.scratch = test_folder() / "probe";
    setting.secrets = {secret_file()};
    if (const char* level = std::getenv("FOS_BOX_LEVEL")) setting.only = level_named(level);
    const ProbeResult result = probe(setting);
    for (const auto& [level, why] : result.not_had) {
      std::cout << name(level) << ": " << why << '\n';
    }
    if (!result.level) {
      std::cout << "NOT RUN: the box is not to be had here\n";
      return std::nullopt;
    }
    BoxSetting had = setting.box;
    had.level = *result.level;
    return had;
  }();
  return box;
}

Box make_box(unsigned slot) {
  return Box(*box_under_test(), slot, test_folder() / ("scratch" + std::to_string(slot)));
}

const Workshop& workshop_under_test() {
  static Workshop shop(this_build(), test_folder() / "workshop");
  static const bool precompiled = shop.precompile(make_box());
  if (!precompiled) throw std::runtime_error("the headers are not precompiled");
  return shop;
}

Errand attack(const std::string& what, const std::vector<std::string>& arguments) {
  static const fs::path program = [] {
    fs::path copy = test_folder() / "attacker";
    fs::copy_file(FOS_ATTACKER, copy, fs::copy_options::overwrite_existing);
    return copy;
  }();
  Errand errand;
  errand.words = {"/box/attacker", what};
  errand.words.insert(errand.words.end(), arguments.begin(), arguments.end());
  errand.shown = {{program, "/box/attacker"}};
  errand.limits.cpu_seconds = 2;
  errand.limits.memory = 256 << 20;
  errand.limits.idle_seconds = 2;
  return errand;
}

}  // namespace fos::grading
