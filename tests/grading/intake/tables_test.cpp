// Rosters and marks of instructors' own, as CSV.
#include <algorithm>

#include "catch2.hpp"
#include "csv.hpp"
#include "overrides.hpp"
#include "roster.hpp"
#include "test_folder.hpp"

using namespace fos;
using namespace fos::grading;

namespace {

using Cells = std::vector<std::string>;

std::string error_of(const auto& work) {
  try {
    work();
  } catch (const TableError& error) {
    return error.what();
  }
  return "";
}

std::string overrides_error(const std::string& table) {
  return error_of([&] { make_overrides(parse_table(table, "o.csv"), stages); });
}

Whose whose_of(const std::string& name, const std::string& number = "") {
  Whose whose;
  whose.id = name;
  whose.name = name;
  whose.number = number;
  whose.source = name + ".zip";
  return whose;
}

}  // namespace

TEST_CASE("CSV as RFC 4180 has it") {
  const Table table = parse_table(
      "name,points\r\n\"O\"\"Hara, Maria\",\"12,5\"\r\n\r\n\"two\r\nlines\", x \r\n,\r\nlast,",
      "t");
  REQUIRE(table.rows.size() == 4);
  CHECK(table.rows[0].cells == Cells{"name", "points"});
  CHECK(table.rows[1].cells == Cells{"O\"Hara, Maria", "12,5"});
  CHECK(table.rows[2].cells == Cells{"two\r\nlines", "x"});
  CHECK(table.rows[2].line == 4);
  CHECK(table.rows[3].cells == Cells{"last", ""});
  CHECK(table.rows[3].line == 7);
}

TEST_CASE("CSV as Excel writes it") {
  CHECK(parse_table("\xEF\xBB\xBF\"a\";b,c;d\n1;2;3", "t").rows[0].cells == Cells{"a", "b,c", "d"});
  CHECK(parse_table("sep=;\na,b,c;d\n", "t").rows[0].cells == Cells{"a,b,c", "d"});
  CHECK(parse_table("a\tb\n", "t").rows[0].cells == Cells{"a", "b"});
  CHECK(parse_table("a\rb\r", "t").rows[1].cells == Cells{"b"});
  CHECK(parse_table("", "t").rows.empty());
  const TestFolder folder;
  const Table table =
      read_table(folder.write("greek.csv", "\xCA\xF9\xE4\xE9\xEA\xFC\xF2;\xC1\xCC\n"));  // 1253
  CHECK(table.rows[0].cells == Cells{"Κωδικός", "ΑΜ"});
}

TEST_CASE("what is wrong with a table is said with its line") {
  CHECK(error_of([] { parse_table("a,b\n\"open,\nb", "t.csv"); }).starts_with("t.csv:2: error: "));
  CHECK(error_of([] { parse_table("a\n\"b\" c", "t.csv"); }).starts_with("t.csv:2: error: "));
  const TestFolder folder;
  CHECK(error_of([&] { read_table(folder.path() / "none.csv"); }).find("none.csv: error: ") !=
        std::string::npos);
  CHECK_THROWS_AS(read_table(folder.path()), TableError);
  CHECK_THROWS_WITH(read_table(folder.write("book.xlsx", std::string("PK\3\4\0\0", 6))),
                    ContainsSubstring("save it as CSV"));
  CHECK_THROWS_AS(make_roster(parse_table("maria,papa\n", "r")), TableError);
  CHECK_THROWS_AS(make_roster(parse_table("", "r")), TableError);
}

TEST_CASE("a username that is somebody's first name finds nobody else") {
  const Roster roster =
      make_roster(parse_table("name,username\nΓιώργος Άλλος,giorgos\n,maria\n", "r.csv"));
  std::vector<Whose> hand_ins = {whose_of("Γιώργος Παπαδόπουλος του Νίκου"),
                                 whose_of("giorgos_lab4"), whose_of("Άλλος Γιώργος"),
                                 whose_of("maria papadaki"), whose_of("lab4 maria v2")};
  match(roster, hand_ins);
  CHECK(hand_ins[0].username.empty());
  CHECK(hand_ins[1].username == "giorgos");
  CHECK(hand_ins[2].username == "giorgos");
  CHECK(hand_ins[3].username.empty());
  CHECK(hand_ins[4].username == "maria");
}

TEST_CASE("a roster finds whose each hand-in is") {
  const Roster roster =
      make_roster(parse_table("Επώνυμο;Όνομα;ΑΜ;Όνομα χρήστη;Email;Identifier\n"
                              "Παπαδόπουλος;Γεώργιος;1115201900123;up123;gp@x.gr;Participant 77\n"
                              "Παππά;Μαρία;1115201900124;up124;mp@x.gr;Participant 78\n"
                              "Νίκου;Νίκος;125;up125;nn@x.gr;Participant 79\n"
                              "Νίκου;Νίκος;126;up126;nn2@x.gr;Participant 80\n"
                              "Απών;Πάντα;127;up127;;\n",
                              "r.csv"));
  REQUIRE(roster.students.size() == 5);
  CHECK(roster.students[0].name == "Γεώργιος Παπαδόπουλος");
  std::vector<Whose> hand_ins = {whose_of("Georgios Papadopoulos", "1115201900123"),  // Open eClass
                                 whose_of("UP124"),              // a folder by username
                                 whose_of("Nikos Nikou", "79"),  // Moodle's participant
                                 whose_of("nikos nikou"),        // which of the two?
                                 whose_of("lab4-up126"),
                                 whose_of("Someone Else"),
                                 whose_of("pappa maria")};
  const Matching matching = match(roster, hand_ins);
  CHECK(hand_ins[0].username == "up123");
  CHECK(hand_ins[0].email == "gp@x.gr");
  CHECK(hand_ins[1].username == "up124");
  CHECK(hand_ins[1].name == "Μαρία Παππά");
  CHECK(hand_ins[2].username == "up125");
  CHECK(hand_ins[3].username.empty());
  CHECK(hand_ins[4].username == "up126");
  CHECK(hand_ins[5].username.empty());
  CHECK(hand_ins[6].username == "up124");
  CHECK(matching.matched == 5);
  REQUIRE(matching.words.size() == 4);
  CHECK(matching.words[0].find("nikos nikou.zip") == 0);
  CHECK(matching.words[1].find("Someone Else.zip") == 0);
  CHECK(matching.words[2].find("r.csv:3: several") == 0);
  CHECK(matching.words[3].find("r.csv:6: no submission of Πάντα Απών") == 0);
}

TEST_CASE("points, with a point or a comma") {
  CHECK(read_points("12") == 1200);
  CHECK(read_points("12.5") == 1250);
  CHECK(read_points("12,50") == 1250);
  CHECK(read_points("0,05") == 5);
  CHECK(read_points(".5") == 50);
  CHECK(read_points("7.") == 700);
  CHECK(read_points("10000") == 1'000'000);
  for (const char* wrong : {"", "-1", "1.234", "1,2,3", "12a", "1e3", "10000.01", "10001", ".",
                            "99999999", "999999999999999999", " 1"}) {
    INFO(wrong);
    CHECK_FALSE(read_points(wrong));
  }
}

TEST_CASE("marks of an instructor's own") {
  const Overrides overrides = make_overrides(
      parse_table("id;stage;points;reason\nmaria;point;12,5;by hand, \nUP7;;0;copied\n"
                  "maria;;90;all in all\n",
                  "o.csv"),
      stages);
  std::vector<Whose> hand_ins = {whose_of("maria"), whose_of("nikos")};
  CHECK_THROWS_WITH(check_overrides(overrides, hand_ins), ContainsSubstring("o.csv:3: error: "));
  hand_ins[1].username = "up7";
  CHECK_NOTHROW(check_overrides(overrides, hand_ins));
  const auto marias = overrides_of(overrides, hand_ins[0]);
  REQUIRE(marias.size() == 2);
  CHECK(marias[0].stage == "point");
  CHECK(marias[0].points == 1250);
  CHECK(marias[0].reason == "by hand,");
  CHECK(marias[1].stage.empty());
  CHECK(overrides_of(overrides, hand_ins[1])[0].reason == "copied");

  CHECK(overrides_error("id,points\nmaria,1\n").starts_with("o.csv:1: error: "));
  const std::string head = "id,stage,points,reason\n";
  CHECK(overrides_error(head + "maria,pointt,1,x\n")
            .starts_with("o.csv:2: error: there is no stage"));
  CHECK(overrides_error(head + "maria,point,many,x\n").find("'many'") != std::string::npos);
  CHECK(overrides_error(head + "maria,point,12,5,x\n").find("more cells") != std::string::npos);
  CHECK(overrides_error(head + "maria,point,12,\n").find("reason") != std::string::npos);
  CHECK(overrides_error(head + ",point,12,x\n").find("no id") != std::string::npos);
  CHECK(overrides_error(head + "m,point,1,x\nn,point,1,x\nM,point,2,x\n") ==
        "o.csv:4: error: line 2 has a mark of M for this already");
}
