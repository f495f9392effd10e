// One submission: which files are found, which are not taken, and what is said.
#include <sys/stat.h>

#include "catch2.hpp"
#include "intake_test.hpp"
#include "limits.hpp"
#include "test_folder.hpp"
#include "test_zip.hpp"

using namespace fos;
using namespace fos::grading;

TEST_CASE("a folder: the stage files at any depth, byte for byte") {
  const TestFolder folder;
  folder.write("labs/lecture03/flat_color.cpp", "one\r\ntwo");
  folder.write("deep/er/still/ambient.cpp", "");
  folder.write("point.cpp", "// φως\n");
  folder.write("notes.txt", "no");
  const HandIn hand_in = read_one(folder.path());
  CHECK(file_of(hand_in, "flat_color").content == "one\r\ntwo");
  CHECK(file_of(hand_in, "ambient").why == Why::none);
  CHECK(file_of(hand_in, "point").content == "// φως\n");
  CHECK(file_of(hand_in, "directional").why == Why::missing);
  CHECK(file_of(hand_in, "directional").words.find("directional.cpp") != std::string::npos);
  CHECK(hand_in.notes.size() == 2);  // two are missing
  CHECK(hand_in.whose.source == ".");
}

TEST_CASE("a zip: as the student's command makes it, or any other") {
  const TestFolder folder;
  const auto zip = folder.write("hand in.zip", zip_of({{"lecture03/flat_color.cpp", "A"},
                                                       {"lecture04/", ""},
                                                       {"lecture04/ambient.cpp", "B", 0, false},
                                                       {"lecture04/point.cpp", "C"},
                                                       {"lecture04/directional.cpp", "D"},
                                                       {"lecture04/combined.cpp", "E"}}));
  const HandIn hand_in = read_one(zip);
  std::string all;
  for (const StageFile& file : hand_in.files) all += file.content;
  CHECK(all == "ABCDE");
  CHECK(hand_in.notes.empty());
  CHECK(hand_in.whose.id == "hand-in");
  CHECK(hand_in.whose.name == "hand in");
}

TEST_CASE("zips within: opened, down to a limit") {
  const TestFolder folder;
  std::string zip = zip_of({{"point.cpp", "deep"}});
  for (int i = 0; i < most_nested; ++i) zip = zip_of({{"inner.zip", zip}});
  CHECK(file_of(read_one(folder.write("a.zip", zip)), "point").content == "deep");
  const HandIn deeper = read_one(folder.write("b.zip", zip_of({{"inner.zip", zip}})));
  CHECK(file_of(deeper, "point").why == Why::missing);
  CHECK(has_note(deeper, "too many zips deep"));

  folder.write("folder/My Work.ZIP", zip_of({{"x/ambient.cpp", "inside"}}));
  folder.write("folder/point.cpp", "outside");
  const HandIn both = read_one(folder.path() / "folder");
  CHECK(file_of(both, "ambient").content == "inside");
  CHECK(file_of(both, "point").content == "outside");
}

TEST_CASE("twice: equal copies are one, different ones are none, the kit's place decides") {
  const TestFolder folder;
  folder.write("a/point.cpp", "same");
  folder.write("b/point.cpp", "same");
  CHECK(file_of(read_one(folder.write("equal.zip", zip_of({{"x/point.cpp", "same"},
                                                           {"lecture04/point.cpp", "same"}}))),
                "point")
            .content == "same");
  const HandIn differ = read_one(folder.write(
      "differ.zip", zip_of({{"x/point.cpp", "one"}, {"lecture04/point.cpp", "another"}})));
  CHECK(file_of(differ, "point").why == Why::twice);
  CHECK(file_of(differ, "point").content.empty());
  CHECK(has_note(differ, "x/point.cpp"));
  const HandIn kit = read_one(
      folder.write("kit.zip", zip_of({{"fos/tests/check/shipped/lecture04/point.cpp", "stub"},
                                      {"fos/labs/lecture04/point.cpp", "mine"},
                                      {"fos/labs/lecture04/point.cpp.1.old", "older"}})));
  CHECK(file_of(kit, "point").content == "mine");
  CHECK(has_note(kit, "fos/labs/lecture04/point.cpp"));
  const HandIn kits = read_one(folder.write(
      "kits.zip",
      zip_of({{"labs/lecture04/point.cpp", "mine"}, {"old/labs/lecture04/point.cpp", "older"}})));
  CHECK(file_of(kits, "point").why == Why::twice);
  // One name twice in one zip is twice, whichever a tool would take.
  const HandIn again =
      read_one(folder.write("again.zip", zip_of({{"point.cpp", "one"}, {"point.cpp", "two"}})));
  CHECK(file_of(again, "point").why == Why::twice);
}

TEST_CASE("what machines leave beside files is not looked at") {
  const TestFolder folder;
  const HandIn hand_in =
      read_one(folder.write("mac.zip", zip_of({{"work/point.cpp", "mine"},
                                               {"__MACOSX/work/._point.cpp", "finder"},
                                               {"__MACOSX/work/point.cpp", "finder"},
                                               {"work/.DS_Store", "finder"},
                                               {"work/.history/point.cpp", "older"},
                                               {"work/Thumbs.db", "windows"}})));
  CHECK(file_of(hand_in, "point").content == "mine");
  CHECK(hand_in.notes.size() == 4);  // four are missing
}

TEST_CASE("text: UTF-8, and what Greek machines save") {
  const TestFolder folder;
  const std::string nul("int a;\0int b;", 13);
  std::string wide = "\xFF\xFE";
  for (const char letter : std::string("int a;")) (wide += letter) += '\0';
  const HandIn hand_in = read_one(folder.write(
      "text.zip", zip_of({{"flat_color.cpp", "// \xF6\xF9\xF2\n"},  // φως in Windows-1253
                          {"ambient.cpp", nul},
                          {"point.cpp", wide},
                          {"directional.cpp", "\xEF\xBB\xBFint a;"},
                          {"combined.cpp", "\x89PNG\r\n\x1A\n\xC1\xD8"}})));
  CHECK(file_of(hand_in, "flat_color").content == "// φως\n");
  CHECK(has_note(hand_in, "Windows-1253"));
  CHECK(file_of(hand_in, "ambient").why == Why::not_text);
  CHECK(file_of(hand_in, "point").content == "int a;");
  CHECK(file_of(hand_in, "directional").content == "\xEF\xBB\xBFint a;");
  CHECK(file_of(hand_in, "combined").why == Why::not_text);
}

TEST_CASE("size: 256 KiB and no more, whatever is claimed") {
  const TestFolder folder;
  const std::string most(most_file, ' ');
  const HandIn hand_in = read_one(
      folder.write("sizes.zip", zip_of({{"flat_color.cpp", most}, {"ambient.cpp", most + " "}})));
  CHECK(file_of(hand_in, "flat_color").content.size() == most_file);
  CHECK(file_of(hand_in, "ambient").why == Why::too_large);
  folder.write("folder/flat_color.cpp", most);
  folder.write("folder/ambient.cpp", most + " ");
  const HandIn plain = read_one(folder.path() / "folder");
  CHECK(file_of(plain, "flat_color").content.size() == most_file);
  CHECK(file_of(plain, "ambient").why == Why::too_large);
}

TEST_CASE("names: another case, other names, other archives") {
  const TestFolder folder;
  const HandIn hand_in = read_one(folder.write("names.zip", zip_of({{"Point.CPP", "mine"},
                                                                    {"ambient (1).cpp", "copy"},
                                                                    {"directional.cpp.txt", "text"},
                                                                    {"work.rar", "Rar!"}})));
  CHECK(file_of(hand_in, "point").content == "mine");
  CHECK(has_note(hand_in, "Point.CPP"));
  CHECK(file_of(hand_in, "ambient").why == Why::missing);
  CHECK(has_note(hand_in, "ambient (1).cpp, directional.cpp.txt"));
  CHECK(has_note(hand_in, "work.rar is a .rar"));
}

TEST_CASE("links, devices and pipes are no files, and are never followed") {
  const TestFolder folder;
  folder.write("secret/point.cpp", "secret");
  folder.write("hand_in/ambient.cpp", "mine");
  const auto in = folder.path() / "hand_in";
  std::filesystem::create_symlink("../secret/point.cpp", in / "point.cpp");
  std::filesystem::create_directory_symlink("../secret", in / "secret");
  std::filesystem::create_symlink("/dev/zero", in / "combined.cpp");
  std::filesystem::create_symlink("nowhere", in / "work.zip");
  REQUIRE(mkfifo((in / "directional.cpp").c_str(), 0600) == 0);
  const HandIn hand_in = read_one(in);
  CHECK(file_of(hand_in, "ambient").content == "mine");
  CHECK(file_of(hand_in, "point").why == Why::link);
  CHECK(file_of(hand_in, "combined").why == Why::link);
  CHECK(file_of(hand_in, "directional").why == Why::special);
  CHECK(has_note(hand_in, "work.zip is a symbolic link"));

  const HandIn zipped = read_one(
      folder.write("links.zip", zip_of({{"point.cpp", "../secret/point.cpp", 0, false, 0120777},
                                        {"directional.cpp", "", 0, false, 0020666},
                                        {"ambient.cpp", "locked", 0, true, 0100644, 1}})));
  CHECK(file_of(zipped, "point").why == Why::link);
  CHECK(file_of(zipped, "directional").why == Why::special);
  CHECK(file_of(zipped, "ambient").why == Why::encrypted);
}

TEST_CASE("an empty folder and an empty zip are submissions of nothing") {
  const TestFolder folder;
  for (const auto& path : {folder.folder("empty"), folder.write("empty.zip", zip_of({}))}) {
    const HandIn hand_in = read_one(path);
    for (const StageFile& file : hand_in.files) CHECK(file.why == Why::missing);
  }
}
