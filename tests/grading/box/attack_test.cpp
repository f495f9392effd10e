// What the box must keep in: each attack fails, and nothing outside has changed.
#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "catch2.hpp"
#include "grading/box/box_under_test.hpp"

using namespace fos::grading;

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ostringstream words;
  words << std::ifstream(file).rdbuf();
  return words.str();
}

/// A process of the grader's that sleeps.
class Bystander {
 public:
  Bystander() : pid_(fork()) {
    if (pid_ == 0) {
      for (;;) pause();
    }
  }
  ~Bystander() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Bystander(const Bystander&) = delete;
  Bystander& operator=(const Bystander&) = delete;
  std::string pid() const { return std::to_string(pid_); }
  bool lives() const { return waitpid(pid_, nullptr, WNOHANG) == 0; }

 private:
  pid_t pid_;
};

/// How many processes are called that.
int processes_called(const std::string& name) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::string first;
    std::getline(std::ifstream(entry.path() / "comm"), first);
    if (first == name) ++count;
  }
  return count;
}

std::string solution() { return FOS_SOURCE_FOLDER "/solutions/lecture04/point.cpp"; }

std::string own_pid() { return std::to_string(getpid()); }

}  // namespace

TEST_CASE("outside the box the attacks work") {
  const Bystander bystander;
  const auto outside = [](const std::string& what, const std::string& argument) {
    const std::string program = attack("").shown[0].host.string();
    return std::system((program + " \"" + what + "\" " + argument + " >/dev/null 2>&1").c_str());
  };
  CHECK(outside("reads", secret_file().string()) == 0);
  CHECK(outside("connects", "9") == 0);
  CHECK(outside("sees processes", bystander.pid()) == 0);
  CHECK(outside("limits others", bystander.pid()) == 0);
  CHECK(outside("kills", bystander.pid()) == 0);
  CHECK(outside("lists environment", "") == 0);
}

TEST_CASE("a level in which a secret can be read is not taken") {
  FOS_NEEDS_BOX();
  ProbeSetting setting;
  setting.box = *box_under_test();
  setting.only = setting.box.level;
  setting.scratch = test_folder() / "probe";
  setting.secrets = {"/usr/lib"};
  const auto result = probe(setting);
  CHECK_FALSE(result.level);
  REQUIRE(result.not_had.size() == 1);
  CHECK_THAT(result.not_had[0].why, ContainsSubstring("/usr/lib"));
  setting.only = Level::none;
  CHECK_FALSE(probe(setting).level);
  setting.unsafe = true;
  CHECK(probe(setting).level == Level::none);
}

TEST_CASE("it reads nothing that is not shown") {
  FOS_NEEDS_BOX();
  std::vector<std::string> paths{secret_file().string()};
  if (box_under_test()->level != Level::uid) {
    paths.insert(paths.end(),
                 {test_folder().string(), solution(), std::string(FOS_SOURCE_FOLDER) + "/tests",
                  "/etc/passwd", "/etc/shadow", "/root", "/home", "/var", "/usr/local", "/tmp/.."});
    if (box_under_test()->level == Level::bubblewrap) paths.resize(paths.size() - 1);
  }
  const auto result = run(make_box(), attack("reads", paths));
  INFO(result.output);
  CHECK(result.ending == RunEnding::exited);
  CHECK(result.status == 1);
}

TEST_CASE("it writes nowhere but where it may") {
  FOS_NEEDS_BOX();
  const auto result =
      run(make_box(), attack("writes", {secret_file().string(), "/usr/lib/fos-x", "/etc/fos-x",
                                        "/proc/sys/kernel/fos-x", "/box/attacker"}));
  INFO(result.output);
  CHECK(result.status == 1);
  CHECK(contents(secret_file()) == "the reference\n");
  if (box_under_test()->level == Level::bubblewrap) {
    const auto others = run(make_box(), attack("fills memory files"));
    INFO(others.output);
    CHECK(others.status == 1);
  }
}

TEST_CASE("there is no network") {
  FOS_NEEDS_BOX();
  const int server = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  REQUIRE(bind(server, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0);
  REQUIRE(listen(server, 1) == 0);
  socklen_t size = sizeof(address);
  getsockname(server, reinterpret_cast<sockaddr*>(&address), &size);
  const auto result =
      run(make_box(), attack("connects", {std::to_string(ntohs(address.sin_port))}));
  close(server);
  INFO(result.output);
  CHECK(result.ending == RunEnding::exited);
  CHECK(result.status == 1);
}

TEST_CASE("it reaches no process outside") {
  FOS_NEEDS_BOX();
  const Bystander bystander;
  const Box box = make_box();
  for (const char* what : {"kills", "limits others"}) {
    const auto result = run(box, attack(what, {bystander.pid(), own_pid()}));
    INFO(what << ": " << result.output);
    CHECK(result.ending == RunEnding::exited);
    CHECK(result.status == 1);
  }
  if (box.level() == Level::bubblewrap) {
    CHECK(run(box, attack("sees processes", {bystander.pid()})).status == 1);
  }
  CHECK(bystander.lives());
}

TEST_CASE("its supervisor withstands it") {
  FOS_NEEDS_BOX();
  const Bystander bystander;
  const Box box = make_box();
  const auto result = run(box, attack("kills around"));
  CHECK(result.ending != RunEnding::infrastructure);
  CHECK_FALSE(result.succeeded());
  const auto traces = run(box, attack("traces"));
  INFO(traces.output);
  CHECK(traces.ending == RunEnding::exited);
  CHECK(traces.status == 1);
  CHECK(bystander.lives());
}

TEST_CASE("no namespaces, and no memory that nobody counts") {
  FOS_NEEDS_BOX();
  const auto result = run(make_box(), attack("makes namespaces"));
  INFO(result.output);
  CHECK(result.ending == RunEnding::exited);
  CHECK(result.status == 1);
}

TEST_CASE("a fork bomb is small, and disturbs nobody; nor does a process that hops") {
  FOS_NEEDS_BOX();
  for (const char* what : {"forks for ever", "hops"}) {
    RunResult bomb;
    std::thread other([&] { bomb = run(make_box(1), attack(what)); });
    int failures = 0;
    const Box box = make_box(0);
    for (int i = 0; i < 20; ++i) {
      if (!run(box, attack("nothing")).succeeded()) ++failures;
    }
    other.join();
    INFO(what);
    CHECK(failures == 0);
    CHECK(bomb.ending != RunEnding::infrastructure);
    CHECK_FALSE(bomb.succeeded());
    CHECK(processes_called("attacker") == 0);
  }
}

TEST_CASE("nobody stays") {
  FOS_NEEDS_BOX();
  CHECK(run(make_box(), attack("stays", {"fos-stays"})).succeeded());
  CHECK(processes_called("fos-stays") == 0);
}

TEST_CASE("descriptors and environment of the grader do not come in") {
  FOS_NEEDS_BOX();
  const int open_here = fcntl(0, F_DUPFD, 20);  // without close-on-exec
  setenv("FOS_SECRET", "reference", 1);
  const Box box = make_box();
  for (const char* what : {"lists descriptors", "lists environment"}) {
    const auto result = run(box, attack(what));
    INFO(what << ": " << result.output);
    CHECK(result.status == 1);
  }
  close(open_here);
}

TEST_CASE("a child's signal is its own") {
  FOS_NEEDS_BOX();
  const char* abi = std::getenv("FOS_BOX_LANDLOCK_ABI");
  if (abi != nullptr && geteuid() != 0) return;  // there no signal goes to any other process
  CHECK(run(make_box(), attack("aborts in a child")).succeeded());
}

TEST_CASE("what one slot writes, another does not see") {
  FOS_NEEDS_BOX();
  const Box one = make_box(0);
  run(one, attack("writes a huge file"));
  const auto reads =
      run(make_box(1), attack("reads", {"huge", (test_folder() / "scratch0/huge").string(),
                                        (test_folder() / "scratch0").string()}));
  INFO(reads.output);
  if (one.user() != 0 || one.level() != Level::uid) CHECK(reads.status == 1);
}
