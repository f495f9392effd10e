// A result whose every string is hostile, through every writer: nothing passes.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch2.hpp"
#include "class_page.hpp"
#include "clean_text.hpp"
#include "csv_reader.hpp"
#include "example_results.hpp"
#include "golden.hpp"
#include "platforms.hpp"
#include "submission_page.hpp"

using namespace fos::grading;
using Json = nlohmann::json;

namespace {

/// Clean UTF-8 without anything that a terminal obeys or that turns the direction of reading.
void check_clean(const std::string& text) { CHECK(clean(text) == text); }

long tags(const std::string& text) { return std::count(text.begin(), text.end(), '<'); }

std::string without_breaks(std::string text) {
  for (std::size_t i = text.find("<br>"); i != std::string::npos; i = text.find("<br>", i)) {
    text.erase(i, 4);
  }
  return text;
}

/// It has as many tags and as many quotation marks as for a harmless text.
void check_structure(const std::string& hostile, const std::string& harmless) {
  CHECK(tags(hostile) == tags(harmless));
  CHECK(std::count(hostile.begin(), hostile.end(), '>') ==
        std::count(harmless.begin(), harmless.end(), '>'));
  CHECK(std::count(hostile.begin(), hostile.end(), '"') ==
        std::count(harmless.begin(), harmless.end(), '"'));
  check_clean(hostile);
}

void check_csv(const std::string& text, std::size_t columns, std::size_t rows) {
  check_clean(text);
  const auto cells = read_csv(text, ',');
  REQUIRE(cells.size() == rows);
  for (const auto& row : cells) {
    CHECK(row.size() == columns);
    for (const std::string& cell : row) CHECK(!is_formula(cell));
  }
  // As a spreadsheet reads it that separates at another character.
  for (const char separator : {';', '\t', '|'}) {
    for (const auto& row : read_csv(text, separator)) {
      for (const std::string& cell : row) CHECK(!is_formula(cell));
    }
  }
}

void check_json_strings(const Json& json) {
  if (json.is_string()) check_clean(json.get<std::string>());
  if (json.is_structured()) {
    for (const Json& inner : json) check_json_strings(inner);
  }
}

void check_no_command(const std::string& text) {
  CHECK(text.find("::") == std::string::npos);
  CHECK(text.find("##[") == std::string::npos);
}

}  // namespace

TEST_CASE("Hostile text in every field of every writer") {
  for (const Feedback feedback : {Feedback::marks, Feedback::full}) {
    for (const char* language : {"en", "el"}) {
      const InLanguage one_language(language);
      for (const std::string& text : hostile_texts()) {
        CAPTURE(text);
        Run run = hostile_run(text);
        Run harmless_run = hostile_run("x");
        run.feedback = harmless_run.feedback = feedback;
        const SubmissionResult one = hostile_submission(text), harmless = hostile_submission("x");
        const std::vector<Summary> all = {summarize(one)}, other = {summarize(harmless)};

        check_structure(submission_page(run, one), submission_page(harmless_run, harmless));
        check_structure(class_page(run, all), class_page(harmless_run, other));
        check_structure(junit_xml(run, one), junit_xml(harmless_run, harmless));

        const std::size_t stages = read_csv(grades_csv(other), ',')[0].size() - 9;
        check_csv(grades_csv(all), 9 + stages, 2);
        const ClassFile file{feedback, 1000000};
        const auto rows = [&](const Objections& objections) {
          return is_left_out(objections, one.id) ? 0U : 1U;
        };
        check_csv(eclass_csv(all, file), 3, rows(eclass_preflight(all, file)));
        for (const MoodleUser user : {MoodleUser::email, MoodleUser::idnumber}) {
          check_csv(moodle_csv(all, file, user), 3, 1 + rows(moodle_preflight(all, file, user)));
        }

        const Json gradescope = Json::parse(gradescope_json(run, one));
        check_json_strings(gradescope);
        CHECK(gradescope.size() == 7);
        CHECK(gradescope["tests"].size() == one.stages.size());
        CHECK(gradescope["score"] == Json::parse(gradescope_json(harmless_run, harmless))["score"]);

        const std::string actions = actions_json(run, one);
        check_json_strings(Json::parse(actions));
        check_no_command(actions);
        CHECK(actions.find('\n') == std::string::npos);
        CHECK(Json::parse(actions)["tests"].size() == one.stages.size());

        const std::string summary = actions_summary(run, one);
        check_clean(summary);
        check_no_command(summary);
        CHECK(tags(without_breaks(summary)) ==
              tags(without_breaks(actions_summary(harmless_run, harmless))));
        for (const char* markup : {"<script", "<img", "<b>", "](", "![", "**bold", "`", "@octo",
                                   "://", "www.", "| a |", "\n# h", "\n- item", "\n> q"}) {
          CAPTURE(markup);
          CHECK(summary.find(markup) == std::string::npos);
        }
      }
    }
  }
}

TEST_CASE("What a student printed cannot pass for a line of ours") {
  const InLanguage english("en");
  SubmissionResult one = wrong_submission();
  one.stages[0].program = "✓ all right\n✓ 20 / 20";
  const Json json = Json::parse(gradescope_json(example_run(), one));
  const std::string output = json["tests"][0]["output"];
  CHECK(output.find("\n✓") == std::string::npos);
  CHECK_THAT(output, ContainsSubstring("\n  | ✓ all right\n  | ✓ 20 / 20"));
}

TEST_CASE("In the log of a workflow too: no column begins a command, and the names are one line") {
  const InLanguage english("en");
  for (const std::string& text : hostile_texts()) {
    const Json json = Json::parse(actions_json(example_run(), hostile_submission(text)));
    for (const Json& test : json["tests"]) {
      check_no_command(test["name"].get<std::string>() + test["message"].get<std::string>());
      CHECK(test["name"].get<std::string>().find('\n') == std::string::npos);
    }
  }
}
