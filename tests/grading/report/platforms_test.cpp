// Each platform's file, byte for byte, and what its preflight says.
#include "platforms.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "example_results.hpp"
#include "fos/bitmap.hpp"
#include "golden.hpp"
#include "half_blocks.hpp"

using namespace fos::grading;
using Json = nlohmann::json;

namespace {

std::vector<Summary> example_class() {
  return {summarize(right_submission()), summarize(wrong_submission()),
          summarize(unjudged_submission())};
}

/// The submissions that are objected to, in order, each once.
std::vector<std::string> ids(const Objections& objections) {
  std::vector<std::string> out;
  for (const Objection& one : objections) out.push_back(one.id);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<Summary> two_users(const std::string& a, const std::string& b) {
  std::vector<Summary> out = {summarize(right_submission()), summarize(right_submission())};
  out[0].id = "a";
  out[1].id = "b";
  out[0].username = a;
  out[1].username = b;
  out[0].email = a;
  out[1].email = b;
  return out;
}

long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace

TEST_CASE("grades.csv has everyone, and no mark where there is none") {
  const InLanguage english("en");
  check_golden(grades_csv(example_class()), "grades.csv");
  CHECK(lines(grades_csv({})) == 1);
  CHECK_THAT(grades_csv(example_class()), ContainsSubstring(",20,10,30,20,,,100,"));
}

TEST_CASE("Open eClass: no header, and nobody without a final mark") {
  const InLanguage english("en");
  const std::vector<Summary> all = example_class();
  check_golden(eclass_csv(all, {}), "eclass.csv");
  CHECK(lines(eclass_csv(all, {})) == 2);
  CHECK(ids(eclass_preflight(all, {})) == std::vector<std::string>{"eleni"});
  CHECK(eclass_csv({}, {}).empty());
}

TEST_CASE("Open eClass: what the import would refuse or read as another is left out") {
  const InLanguage english("en");
  const auto written = [](const std::string& user) {
    const std::string csv = eclass_csv(std::vector{two_users(user, "other")[0]}, {});
    return csv.substr(0, csv.find(",100,Fos:"));
  };
  CHECK(written("cs1234") == "cs1234");
  CHECK(written("γιώργος") == "γιώργος");
  CHECK(written("123456") == "123456");
  CHECK(written("00123") == "(00123)");
  CHECK(written("1e5") == "(1e5)");
  CHECK(written("True") == "(True)");
  CHECK(written("12345678901234567890") == "(12345678901234567890)");
  CHECK(written("=1+1") == "(=1+1)");
  for (const char* user : {"", "a(b)", "a)b(", "1)", "x\ny", " x", "a;=1", "\u202Ex\u202C"}) {
    CAPTURE(user);
    CHECK(written(user).empty());
    CHECK(ids(eclass_preflight(std::vector{two_users(user, "x")[0]}, {})).size() == 1);
  }
  CHECK(eclass_csv(two_users("same", "same"), {}).empty());
  CHECK(ids(eclass_preflight(two_users("same", "same"), {})).size() == 2);
  CHECK(eclass_preflight(two_users("one", "other"), {}).empty());
}

TEST_CASE("Marks above the maximum there, or below 0, are left out") {
  const InLanguage english("en");
  std::vector<Summary> all = two_users("one", "other");
  CHECK(ids(eclass_preflight(all, {Feedback::full, 10000})).empty());
  CHECK(ids(eclass_preflight(all, {Feedback::full, 9999})).size() == 2);
  CHECK(ids(moodle_preflight(all, {Feedback::full, 1000}, MoodleUser::email)).size() == 2);
  all[1].points = -100;
  CHECK(ids(moodle_preflight(all, {}, MoodleUser::email)) == std::vector<std::string>{"b"});
  all[0].points = 10100;
  CHECK(eclass_csv(all, {}).empty());
}

TEST_CASE("A comment is one line that no number begins, and says what the feedback allows") {
  for (const char* language : {"en", "el"}) {
    const InLanguage one(language);
    for (const Feedback feedback : {Feedback::marks, Feedback::hints, Feedback::full}) {
      const std::string csv = moodle_csv(std::vector{summarize(wrong_submission())}, {feedback, 0},
                                         MoodleUser::username);
      CHECK(lines(csv) == 2);
      CHECK_THAT(csv, ContainsSubstring(R"(,"Fos:)") || ContainsSubstring(",Fos:"));
      const bool named = csv.find("L is not divided") != std::string::npos;
      CHECK(named == (feedback == Feedback::full));
    }
  }
}

TEST_CASE("Moodle: the grade and the feedback together, the user by the column that is asked for") {
  const std::vector<Summary> all = example_class();
  {
    const InLanguage english("en");
    check_golden(moodle_csv(all, {}, MoodleUser::email), "moodle.csv");
    CHECK(ids(moodle_preflight(two_users("0", "x"), {}, MoodleUser::idnumber)) ==
          std::vector<std::string>{"a"});
    CHECK(ids(moodle_preflight(two_users("", "=x"), {}, MoodleUser::email)).size() == 2);
  }
  const InLanguage greek("el");
  check_golden(moodle_csv(all, {Feedback::hints, 0}, MoodleUser::idnumber), "moodle-el.csv");
}

TEST_CASE("Gradescope: a visible entry a stage, with its points") {
  const InLanguage english("en");
  const std::string text = gradescope_json(example_run(), wrong_submission());
  check_golden(text, "results.json");
  const Json json = Json::parse(text);
  double sum = 0;
  for (const Json& test : json["tests"]) {
    sum += test["score"].get<double>();
    CHECK(test["visibility"] == "visible");
    CHECK(test["score"].get<double>() <= test["max_score"].get<double>());
  }
  CHECK(json["score"].get<double>() == sum);
  CHECK(sum == 10 + 7.5 + 5 + 15);
  CHECK(gradescope_preflight(wrong_submission()).empty());
}

TEST_CASE("Gradescope: a stage that was not judged has no score, and the preflight says so") {
  const InLanguage english("en");
  const Json json = Json::parse(gradescope_json(example_run(), unjudged_submission()));
  CHECK(!json["tests"][4].contains("score"));
  CHECK(!json["tests"][4].contains("status"));
  CHECK_THAT(json["output"].get<std::string>(), ContainsSubstring("no final mark"));
  CHECK(ids(gradescope_preflight(unjudged_submission())).size() == 1);
  CHECK(!gradescope_preflight(unjudged_submission())[0].left_out);
}

TEST_CASE("Gradescope: a picture of half blocks") {
  const InLanguage english("en");
  const fos::Bitmap bitmap{2, 2, {255, 0, 0, 255, 255, 255, 0, 0, 0, 0, 0, 255}};
  const std::string picture = half_blocks(bitmap, 60);
  CHECK(picture == "\033[38;5;196m\033[48;5;16m▀\033[38;5;231m\033[48;5;21m▀\033[0m\n");
  CHECK(lines(half_blocks({600, 600, std::vector<std::uint8_t>(3UL * 600 * 600)}, 60)) == 30);
  CHECK(half_blocks({}, 60).empty());
  const Json json =
      Json::parse(gradescope_json(example_run(), wrong_submission(), {"", "", picture}));
  CHECK(json["tests"].size() == 6);
  CHECK(json["tests"][3]["output_format"] == "ansi");
  CHECK(json["tests"][3]["output"] == picture);
  CHECK(!json["tests"][3].contains("score"));
}

TEST_CASE("GitHub Actions: one result with an entry a stage, and a summary") {
  const InLanguage english("en");
  const std::string text = actions_json(example_run(), wrong_submission());
  check_golden(Json::parse(text).dump(2) + "\n", "actions.json");
  check_golden(actions_output(example_run(), wrong_submission()), "github-output.txt");
  check_golden(actions_summary(example_run(), wrong_submission()), "github-summary.md");
  CHECK(lines(actions_output(example_run(), wrong_submission())) == 1);
  CHECK(Json::parse(text)["status"] == "fail");
  CHECK(Json::parse(actions_json(example_run(), right_submission()))["status"] == "pass");
  CHECK(Json::parse(actions_json(example_run(), unjudged_submission()))["status"] == "error");
  CHECK(actions_preflight(example_run(), right_submission()).empty());
  CHECK(actions_preflight(example_run(), unjudged_submission()).size() == 1);
}

TEST_CASE("GitHub Actions: the entries add up to the mark, also to an instructor's own") {
  const InLanguage english("en");
  SubmissionResult one = wrong_submission();
  const auto sum = [&] {
    double out = 0;
    const Json json = Json::parse(actions_json(example_run(), one));
    for (const Json& test : json["tests"]) {
      out += test["score"].get<double>();
    }
    return out;
  };
  CHECK(sum() == one.points() / 100.0);
  one.overrides.push_back({"", 8000, "seen in class"});
  CHECK(sum() == 80);
}

TEST_CASE("GitHub Actions: the preflight says what does not fit") {
  const InLanguage english("en");
  SubmissionResult one = right_submission();
  one.stages.clear();
  CHECK(actions_preflight(example_run(), one).size() == 1);
  one = wrong_submission();
  one.notes.assign(200, std::string(most_text, '<'));
  CHECK(ids(actions_preflight(example_run(), one)).size() == 1);
}

TEST_CASE("JUnit XML: a case a check") {
  {
    const InLanguage english("en");
    check_golden(junit_xml(example_run(), wrong_submission()), "junit.xml");
    CHECK_THAT(junit_xml(example_run(), unjudged_submission()), ContainsSubstring("<skipped"));
    CHECK(ids(junit_preflight(unjudged_submission())).size() == 1);
    CHECK(junit_preflight(wrong_submission()).empty());
  }
  const InLanguage greek("el");
  check_golden(junit_xml(example_run(), right_submission()), "junit-el.xml");
}

TEST_CASE("A mark for the whole settles a submission, and so does one for the stage in question") {
  Summary one = summarize(unjudged_submission());
  CHECK(!is_settled(one));
  one.overrides = {{"point", 1, ""}};
  CHECK(!is_settled(one));
  one.overrides = {{"combined", 1, ""}};
  CHECK(is_settled(one));
  one.overrides = {{"", 1, ""}};
  CHECK(is_settled(one));
}
