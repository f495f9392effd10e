// A class: what PATH is taken for, and who is in it.
#include "catch2.hpp"
#include "intake_test.hpp"
#include "platform_names.hpp"
#include "test_folder.hpp"
#include "test_zip.hpp"

using namespace fos;
using namespace fos::grading;

namespace {

using Ids = std::vector<std::string>;

std::string hand_in_zip(const std::string& content) {
  return zip_of({{"lecture04/point.cpp", content}});
}

std::string point_of(const ClassFiles& files, std::size_t i) {
  return file_of(files.read(i), "point").content;
}

}  // namespace

TEST_CASE("a folder of submissions: a folder or a zip each") {
  const TestFolder folder;
  folder.write("class/maria/point.cpp", "M");
  folder.write("class/Γιώργος Παπαδόπουλος/labs/lecture04/point.cpp", "G");
  folder.write("class/up1234567.zip", hand_in_zip("U"));
  folder.write("class/nikos.rar", "Rar!");
  folder.write("class/grades.xlsx", "no one's");
  folder.folder("class/eleni");
  folder.write("class/\x8B\xE5\xA8\xA1\x98/point.cpp", "m");  // Μίρκα in the code page 737
  const ClassFiles files = read_class(folder.path() / "class", stages);
  CHECK(files.kind() == ClassKind::folder);
  REQUIRE(ids_of(files) ==
          Ids{"eleni", "giorgos-papadopoulos", "maria", "mirka", "nikos", "up1234567"});
  CHECK(files.whose(1).name == "Γιώργος Παπαδόπουλος");
  CHECK(files.whose(5).source == "up1234567.zip");
  CHECK(point_of(files, 1) == "G");
  CHECK(point_of(files, 2) == "M");
  CHECK(point_of(files, 5) == "U");
  CHECK(file_of(files.read(0), "point").why == Why::missing);
  CHECK(has_note(files.read(4), "nikos.rar is a .rar"));
  REQUIRE(files.notes().size() == 1);
  CHECK(files.notes()[0].find("grades.xlsx") != std::string::npos);
}

TEST_CASE("the same class in a zip, with a folder around it") {
  const TestFolder folder;
  const ClassFiles files =
      read_class(folder.write("class.zip", zip_of({{"lab4/maria/point.cpp", "M"},
                                                   {"lab4/nikos/", ""},
                                                   {"lab4/up1.zip", hand_in_zip("U")},
                                                   {"lab4/maria/../up1/point.cpp", "slip"}})),
                 stages);
  REQUIRE(ids_of(files) == Ids{"maria", "nikos", "up1"});
  CHECK(point_of(files, 0) == "M");
  CHECK(point_of(files, 2) == "U");
  CHECK(files.whose(0).source == "lab4/maria");
}

TEST_CASE("a folder and a zip of one name are one person's") {
  const TestFolder folder;
  folder.write("maria.zip", zip_of({{"point.cpp", "P"}, {"ambient.cpp", "A"}}));
  folder.write("maria/point.cpp", "P");
  folder.write("nikos/point.cpp", "N");
  const ClassFiles files = read_class(folder.path(), stages);
  REQUIRE(ids_of(files) == Ids{"maria", "nikos"});
  CHECK(point_of(files, 0) == "P");
  CHECK(file_of(files.read(0), "ambient").content == "A");
}

TEST_CASE("one person's folders are not a class") {
  const TestFolder folder;
  folder.write("a/lecture03/flat_color.cpp", "1");
  folder.write("a/lecture04/point.cpp", "2");
  CHECK(read_class(folder.path() / "a", stages).kind() == ClassKind::one);
  folder.write("b/first/flat_color.cpp", "1");
  folder.write("b/second/point.cpp", "2");
  CHECK(read_class(folder.path() / "b", stages).kind() == ClassKind::one);
  folder.write("c/labs/lecture04/point.cpp", "1");
  folder.write("c/tests/check/shipped/lecture04/point.cpp", "1");
  folder.write("c/old.zip", hand_in_zip("0"));
  CHECK(read_class(folder.path() / "c", stages).kind() == ClassKind::one);
  folder.write("d/wrapped/around/point.cpp", "1");
  CHECK(point_of(read_class(folder.path() / "d", stages), 0) == "1");
}

TEST_CASE("a class in which nobody has the right names is one all the same") {
  const TestFolder folder;
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    folder.write(std::string(name) + "/main.cpp", "x");
  CHECK(read_class(folder.path(), stages).size() == 6);
}

TEST_CASE("Moodle, in folders and not") {
  const TestFolder folder;
  const ClassFiles flat = read_class(
      folder.write("flat.zip",
                   zip_of({{"Maria Papa_101_assignsubmission_file_point.cpp", "M"},
                           {"Maria Papa_101_assignsubmission_file_ambient.cpp", "MA"},
                           {"Maria Papa_101_assignsubmission_onlinetext_onlinetext.html", "hi"},
                           {"Nikos_O'Hara_102_assignsubmission_file_my work.zip", hand_in_zip("N")},
                           {"Έλλη_103_assignsubmission_file_report.pdf", "%PDF"}})),
      stages);
  CHECK(flat.kind() == ClassKind::moodle);
  REQUIRE(ids_of(flat) == Ids{"elli-103", "maria-papa-101", "nikos_o-hara-102"});
  CHECK(flat.whose(1).name == "Maria Papa");
  CHECK(flat.whose(1).number == "101");
  CHECK(point_of(flat, 1) == "M");
  CHECK(file_of(flat.read(1), "ambient").content == "MA");
  CHECK(point_of(flat, 2) == "N");
  CHECK(file_of(flat.read(0), "point").why == Why::missing);

  folder.write("in/Maria Papa_101_assignsubmission_file_/lecture04/point.cpp", "M");
  folder.write("in/Nikos_102_assignsubmission_file_/w.zip", hand_in_zip("N"));
  folder.write("in/Nikos_102_assignsubmission_onlinetext_/onlinetext.html", "hi");
  const ClassFiles folders = read_class(folder.path() / "in", stages);
  REQUIRE(ids_of(folders) == Ids{"maria-papa-101", "nikos-102"});
  CHECK(point_of(folders, 0) == "M");
  CHECK(point_of(folders, 1) == "N");
}

TEST_CASE("Open eClass") {
  const TestFolder folder;
  const ClassFiles files = read_class(
      folder.write("INF161_work_7.zip",
                   zip_of({{"work_7/index.html", "<html>"},
                           {"work_7/Georgios Papadopoulos1115201900123.zip", hand_in_zip("G")},
                           {"work_7/Maria Papa1115201900124/point.cpp", "M"},
                           {"work_7/Maria Papa1115201900124/ambient.cpp", "MA"},
                           {"work_7/Nikos Nikou.rar", "Rar!"},
                           {"work_7/Eleni Elenidou42424.cpp", "E"}})),
      stages);
  CHECK(files.kind() == ClassKind::eclass);
  REQUIRE(ids_of(files) == Ids{"eleni-elenidou-42424", "georgios-papadopoulos-1115201900123",
                               "maria-papa-1115201900124", "nikos-nikou"});
  CHECK(files.whose(1).number == "1115201900123");
  CHECK(files.whose(1).name == "Georgios Papadopoulos");
  CHECK(point_of(files, 1) == "G");
  CHECK(point_of(files, 2) == "M");
  CHECK(has_note(files.read(0), "Elenidou42424.cpp"));  // whose name does not say which stage
  CHECK(files.notes().empty());
}

TEST_CASE("Gradescope") {
  const TestFolder folder;
  const std::string yaml =
      "---\nsubmission_11:\n  :submitters:\n  - :name: 'Solo O''Hara'\n    :sid: '100'\n"
      "    :email: solo@x.edu\n  :created_at: 2025-01-01 10:00:00.000000000 Z\n  :score: 3.0\n"
      "  :results:\n    tests:\n    - :name: not a person\n"
      "submission_12:\n  :submitters:\n  - :name: Pair One\n    :email: one@x.edu\n"
      "  - :name: Pair Two\n    :email: two@x.edu\n";
  const ClassFiles files = read_class(
      folder.write("submissions.zip",
                   zip_of({{"assignment_9_export/submission_metadata.yml", yaml},
                           {"assignment_9_export/submission_11/point.cpp", "S"},
                           {"assignment_9_export/submission_12/labs/lecture04/point.cpp", "P"},
                           {"assignment_9_export/submission_13/x.txt", ""}})),
      stages);
  CHECK(files.kind() == ClassKind::gradescope);
  REQUIRE(ids_of(files) == Ids{"submission_11", "submission_12", "submission_13"});
  CHECK(files.whose(0).name == "Solo O'Hara");
  CHECK(files.whose(0).number == "100");
  CHECK(files.whose(0).email == "solo@x.edu");
  CHECK(files.whose(1).name == "Pair One, Pair Two");
  CHECK(point_of(files, 1) == "P");
  CHECK(gradescope_names("\0\xFF: [[[\n- :name: x\n  :submitters:\n").empty());
}

TEST_CASE("ids are safe, all different, and the same in any company") {
  const TestFolder folder;
  const std::vector<TestEntry> entries = {{"Νίκη/point.cpp", "1"},
                                          {"ΝΙΚΗ/point.cpp", "2"},
                                          {"🎓/point.cpp", "3"},
                                          {"-rf ../point.cpp", "4"},
                                          {"a\nb\"c'/point.cpp", "5"},
                                          {"Νι\xCC\x81κος/point.cpp", "6"},  // an accent of its own
                                          {std::string(300, 'x') + "/point.cpp", "7"},
                                          {"François Müller/point.cpp", "8"}};
  const ClassFiles files = read_class(folder.write("a.zip", zip_of(entries)), stages);
  const Ids ids = ids_of(files);
  REQUIRE(ids.size() == entries.size());
  for (const std::string& id : ids) {
    INFO(id);
    CHECK(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789._-") == std::string::npos);
    CHECK(id.find_first_of("abcdefghijklmnopqrstuvwxyz0123456789") == 0);
    CHECK(id.size() <= 73);
    CHECK(std::count(ids.begin(), ids.end(), id) == 1);
  }
  const auto has = [&](const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  CHECK(has("rf"));
  CHECK(has("a-b-c"));
  CHECK(has("nikos"));
  CHECK(has("submission"));
  CHECK(has("francois-muller"));
  CHECK_FALSE(has("niki"));  // two of that name, told apart by their hashes

  std::vector<TestEntry> fewer(entries.rbegin(), entries.rend() - 1);
  fewer.push_back(entries[0]);
  CHECK(ids_of(read_class(folder.write("b.zip", zip_of(fewer)), stages)) == ids);
}

TEST_CASE("two thousand submissions are read one at a time") {
  const TestFolder folder;
  std::vector<TestEntry> entries;
  for (int i = 0; i < 2000; ++i) {
    const std::string zip = zip_of({{"point.cpp", std::to_string(i)}});
    entries.push_back({"class/s" + std::to_string(10000 + i) + ".zip", zip, 0, false});
  }
  const ClassFiles files = read_class(folder.write("class.zip", zip_of(entries)), stages);
  REQUIRE(files.size() == 2000);
  CHECK(point_of(files, 0) == "0");
  CHECK(point_of(files, 1999) == "1999");
}
