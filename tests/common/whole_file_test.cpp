#include "fos/whole_file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "catch2.hpp"
#include "folder.hpp"

using namespace fos;
namespace fs = std::filesystem;

namespace {

std::string contents(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a file appears at commit, whole, over the older one") {
  const Folder folder;
  const fs::path path = folder.path / "εικόνα.png";
  std::ofstream(path) << "old";
  {
    WholeFile file(path);
    std::ofstream(file.temporary()) << "new";
    CHECK(contents(path) == "old");
    file.commit();
  }
  CHECK(contents(path) == "new");
  CHECK(folder.entries() == 1);
}

TEST_CASE("without commit nothing changes and nothing is left") {
  const Folder folder;
  const fs::path path = folder.path / "a.png";
  std::ofstream(path) << "old";
  {
    WholeFile file(path);
    std::ofstream(file.temporary()) << "half";
  }
  CHECK(contents(path) == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("Ctrl-C leaves nothing behind") {
  const Folder folder;
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);  // Catch2 has a way of its own
    WholeFile file(folder.path / "a.png");
    std::ofstream(file.temporary()) << "half";
    raise(SIGINT);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGINT);
  CHECK(folder.entries() == 0);
}

TEST_CASE("a program that ends in order at Ctrl-C still does, with the file whole") {
  const Folder folder;
  const pid_t child = fork();
  if (child == 0) {
    static volatile std::sig_atomic_t interrupted = 0;
    std::signal(SIGINT, [](int) { interrupted = 1; });
    WholeFile file(folder.path / "a.png");
    std::ofstream(file.temporary()) << "whole";
    raise(SIGINT);
    file.commit();
    _exit(interrupted == 1 ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(contents(folder.path / "a.png") == "whole");
}

TEST_CASE("a path that cannot be written is wrong input, a full disk is not") {
  const Folder folder;
  const auto status_of = [](const fs::path& path) {
    try {
      WholeFile file(path);
      file.commit();
      return 0;
    } catch (const FileError& error) {
      return error.exit_status;
    }
  };
  CHECK(status_of(folder.path / "no such folder" / "a.png") == 2);
  CHECK(status_of(folder.path) == 2);
  CHECK(status_of(folder.path / std::string(300, 'x')) == 2);
  const WholeFile file(folder.path / "a.png");
  CHECK(file.write_error("no space").exit_status == 3);
}
