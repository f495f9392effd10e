#include "journal.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>

#include "catch2.hpp"
#include "result_json.hpp"
#include "result_key.hpp"
#include "sample_result.hpp"
#include "test_folder.hpp"

using namespace fos;
using namespace fos::grading;

namespace {

SubmissionResult result_of(const std::string& id, const std::string& key) {
  SubmissionResult result = sample_result(id);
  result.key = key;
  return result;
}

HandIn hand_in_of(const std::string& content) {
  HandIn hand_in;
  hand_in.files = {{"point", content, Why::none, ""}, {"combined", "", Why::missing, "words"}};
  return hand_in;
}

}  // namespace

TEST_CASE("a key is of the files, the seed, the toolkit and the settings, and of nothing else") {
  HandIn hand_in = hand_in_of("a");
  const std::string key = result_key(hand_in, 1, "1.0", "full");
  CHECK(key.size() == 64);
  CHECK(result_key(hand_in_of("b"), 1, "1.0", "full") != key);
  CHECK(result_key(hand_in, 2, "1.0", "full") != key);
  CHECK(result_key(hand_in, 1, "1.1", "full") != key);
  CHECK(result_key(hand_in, 1, "1.0", "marks") != key);
  CHECK(result_key(hand_in, 1, "1.0f", "ull") != key);
  CHECK(result_key(hand_in, 1, "1.0:4", "full") != result_key(hand_in, 1, "1.0", "4:full"));
  hand_in.whose.name = "another";
  hand_in.notes = {"a note"};
  hand_in.files[1].words = "other words";
  CHECK(result_key(hand_in, 1, "1.0", "full") == key);
  hand_in.files[1].why = Why::twice;
  CHECK(result_key(hand_in, 1, "1.0", "full") != key);
}

TEST_CASE("what is finished is not done again") {
  const TestFolder folder;
  {
    Journal journal(folder.path() / "new" / "out");
    journal.write(result_of("maria", "k1"));
    SubmissionResult troubled = result_of("nikos", "k2");
    troubled.status = Status::not_judged;
    journal.write(troubled);
    CHECK(journal.is_finished("maria", "k1"));
  }
  Journal journal(folder.path() / "new" / "out");
  CHECK_FALSE(journal.is_finished("maria", "k1"));  // not loaded yet
  journal.load();
  CHECK(journal.is_finished("maria", "k1"));
  CHECK_FALSE(journal.is_finished("maria", "k9"));
  CHECK_FALSE(journal.is_finished("nikos", "k2"));
  CHECK_FALSE(journal.is_finished("eleni", "k1"));
  REQUIRE(journal.read("maria"));
  CHECK(to_json(*journal.read("maria")) == to_json(result_of("maria", "k1")));
  CHECK(journal.damaged().empty());
  journal.write(result_of("maria", "k9"));
  CHECK(journal.is_finished("maria", "k9"));
}

TEST_CASE("damaged results are as if they were not there") {
  const TestFolder folder;
  { Journal(folder.path()).write(result_of("maria", "k1")); }
  const std::string good = to_json(result_of("maria", "k1"));
  folder.write("results/cut/result.json", good.substr(0, good.size() / 2));
  folder.write("results/empty/result.json", "");
  folder.write("results/moved/result.json", good);
  folder.folder("results/folder/result.json");
  folder.write("results/begun/.result.json.123.part", good);
  folder.write("results/file", "");
  std::string flipped = to_json(result_of("flipped", "k1"));
  flipped[flipped.find("nikos@")] = 'N';  // valid JSON, and another's mail
  folder.write("results/flipped/result.json", flipped);
  Journal journal(folder.path());
  journal.load();
  CHECK(journal.is_finished("maria", "k1"));
  CHECK(journal.damaged().size() == 5);
  for (const char* id : {"cut", "empty", "moved", "folder", "begun", "flipped"})
    CHECK_FALSE(journal.read(id));
  journal.write(result_of("cut", "k2"));
  journal.load();
  CHECK(journal.is_finished("cut", "k2"));
}

TEST_CASE("two runs do not mix, and a dead one holds nothing") {
  const TestFolder folder;
  {
    const Journal first(folder.path());
    CHECK_THROWS_WITH(Journal(folder.path()), ContainsSubstring(std::to_string(getpid())));
  }
  const pid_t child = fork();
  if (child == 0) {
    Journal journal(folder.path());
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  CHECK_NOTHROW(Journal(folder.path()));
}

TEST_CASE("where nothing can be written it says so, and loses nothing") {
  const TestFolder folder;
  folder.write("file", "");
  CHECK_THROWS_AS(Journal(folder.path() / "file" / "out"), FileError);
  Journal journal(folder.path() / "out");
  journal.write(result_of("maria", "k1"));
  CHECK_THROWS_AS(journal.write(result_of("../escaped", "k1")), FileError);

  // A disk that is full in the middle of a file, as a limit on its length.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  int status = 0;
  try {
    journal.write(result_of("maria", "k2"));
  } catch (const FileError& error) {
    status = error.exit_status;
  }
  setrlimit(RLIMIT_FSIZE, &before);
  CHECK(status == 3);
  journal.load();
  CHECK(journal.is_finished("maria", "k1"));
  CHECK(journal.damaged().empty());
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out/results/maria"))
    files += entry.exists() ? 1 : 0;
  CHECK(files == 1);  // no half of one is left
}

TEST_CASE("two thousand results are there again at once") {
  const TestFolder folder;
  for (int i = 0; i < 2000; ++i) {
    const std::string id = "s" + std::to_string(i);
    folder.write("results/" + id + "/result.json", to_json(result_of(id, "k")));
  }
  Journal journal(folder.path());
  const std::clock_t began = std::clock();
  journal.load();
  const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  UNSCOPED_INFO("2,000 results of " << to_json(sample_result("a")).size() / 1024
                                    << " KiB: " << seconds << " s of CPU time");
  CHECK(seconds < 2);
  CHECK(journal.is_finished("s0", "k"));
  CHECK(journal.is_finished("s1999", "k"));
}
