#include "file_watcher.hpp"

#include <fstream>

#include "catch2.hpp"
#include "common/folder.hpp"

using namespace fos;
using Change = FileWatcher::Change;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& path, const std::string& words) {
  std::ofstream(path, std::ios::binary) << words;
}

const FileWatcher::Clock::time_point start = FileWatcher::Clock::now();
FileWatcher::Clock::time_point after(double seconds) {
  return start + std::chrono::milliseconds(static_cast<int>(1000 * seconds));
}

}  // namespace

TEST_CASE("a change is another content, or another time") {
  const Folder folder;
  const fs::path path = folder.path / "a.cpp";
  write(path, "one");
  FileWatcher file(path);
  CHECK(file.look() == Change::none);
  const auto time = fs::last_write_time(path);
  write(path, "two");
  fs::last_write_time(path, time);  // as where times are in whole seconds
  CHECK(file.look() == Change::changed);
  CHECK(file.content() == "two");
  CHECK(file.look() == Change::none);
  fs::last_write_time(path, time + std::chrono::seconds(3));
  CHECK(file.look() == Change::changed);
  fs::last_write_time(path, time - std::chrono::hours(3));  // an older file, put back
  CHECK(file.look() == Change::changed);
  CHECK(file.look() == Change::none);
}

TEST_CASE("an editor may replace the file by another") {
  const Folder folder;
  const fs::path path = folder.path / "a.cpp";
  write(path, "one");
  FileWatcher file(path);
  write(folder.path / "new", "two");
  fs::rename(folder.path / "new", path);
  CHECK(file.look() == Change::changed);
  CHECK(file.content() == "two");
}

TEST_CASE("a file that is gone for a moment is no change") {
  const Folder folder;
  const fs::path path = folder.path / "a.cpp";
  write(path, "one");
  FileWatcher file(path);
  fs::rename(path, folder.path / "kept");
  CHECK(file.look(after(0)) == Change::none);
  CHECK(file.look(after(0.9)) == Change::none);
  fs::rename(folder.path / "kept", path);
  CHECK(file.look(after(1)) == Change::none);
  CHECK(file.look(after(5)) == Change::none);
}

TEST_CASE("a file that stays away is told of once, and its return is a change") {
  const Folder folder;
  const fs::path path = folder.path / "a.cpp";
  write(path, "one");
  FileWatcher file(path);
  fs::rename(path, folder.path / "kept");
  CHECK(file.look(after(0)) == Change::none);
  CHECK(file.look(after(1.1)) == Change::missing);
  CHECK(file.look(after(9)) == Change::none);
  fs::rename(folder.path / "kept", path);
  CHECK(file.look(after(10)) == Change::changed);
  CHECK(file.look(after(11)) == Change::none);
}
