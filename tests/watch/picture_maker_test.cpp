#include "picture_maker.hpp"

#include <csignal>
#include <fstream>

#include "catch2.hpp"
#include "common/folder.hpp"

using namespace fos;

namespace {

const Panel panel{"μία", {2, 1, {1, 2, 3, 4, 5, 6}}};

bool is_png(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string begin(4, ' ');
  in.read(begin.data(), 4);
  return begin == "\x89PNG";
}

}  // namespace

TEST_CASE("one program makes picture after picture") {
  const Folder folder;
  PictureMaker maker(FOS_PICTURE_PROGRAM);
  const pid_t process = maker.process();
  CHECK(process > 0);
  CHECK(maker.make({folder.path / "a.png", {panel, panel, panel}, 100}));
  CHECK(maker.make({folder.path / "b.png", {panel}, 0}));
  CHECK(is_png(folder.path / "a.png"));
  CHECK(is_png(folder.path / "b.png"));
  CHECK(maker.process() == process);
}

TEST_CASE("what stands in the way of one picture is said, and the next is made") {
  const Folder folder;
  PictureMaker maker(FOS_PICTURE_PROGRAM);
  CHECK_FALSE(maker.make({folder.path / "no" / "a.png", {panel}, 0}));
  CHECK_THAT(maker.error(), ContainsSubstring("a.png"));
  CHECK(maker.make({folder.path / "a.png", {panel}, 0}));
  CHECK(maker.error().empty());
}

TEST_CASE("a program that dies is started anew at the next picture") {
  const Folder folder;
  PictureMaker maker(FOS_PICTURE_PROGRAM);
  REQUIRE(maker.make({folder.path / "a.png", {panel}, 0}));
  const pid_t process = maker.process();
  kill(process, SIGKILL);
  CHECK_FALSE(maker.make({folder.path / "b.png", {panel}, 0}));
  CHECK_THAT(maker.error(), ContainsSubstring("fos_picture"));
  CHECK(maker.make({folder.path / "b.png", {panel}, 0}));
  CHECK(maker.process() != process);
  CHECK(is_png(folder.path / "b.png"));
}

TEST_CASE("a program that is not there makes no picture") {
  PictureMaker maker("/no/such/program");
  CHECK_FALSE(maker.make({"a.png", {panel}, 0}));
  CHECK_FALSE(maker.error().empty());
}
