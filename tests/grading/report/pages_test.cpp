// What the pages show, and what they keep to themselves.
#include <nlohmann/json.hpp>

#include "catch2.hpp"
#include "class_page.hpp"
#include "class_statistics.hpp"
#include "example_results.hpp"
#include "folder.hpp"
#include "fos/whole_file.hpp"
#include "golden.hpp"
#include "report_files.hpp"
#include "submission_page.hpp"

using namespace fos::grading;
namespace fs = std::filesystem;

namespace {

bool has(const std::string& page, std::string_view words) {
  return page.find(words) != std::string::npos;
}

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("A student is told what the instructor wants told") {
  const InLanguage english("en");
  Run run = example_run();
  const auto page = [&](Feedback feedback) {
    run.feedback = feedback;
    return submission_page(run, wrong_submission());
  };
  const std::string marks = page(Feedback::marks), hints = page(Feedback::hints),
                    full = page(Feedback::full);
  for (const std::string& one : {marks, hints, full}) {
    CHECK(has(one, "7.5 / 30"));
    CHECK(has(one, "does not compile"));
    CHECK(has(one, "&#39;intensty&#39; was not declared"));
    CHECK(has(one, "found twice"));
    CHECK(has(one, "a typing error in the last minute"));
    CHECK(has(one, "costs nothing here"));
    CHECK(has(one, "bubblewrap"));
    CHECK(has(one, "20241125"));
    CHECK(has(one, "5e1f09a2"));
    CHECK(!has(one, "index.html"));
    CHECK(!has(one, "<script"));
  }
  CHECK(!has(marks, "Which length has L"));
  CHECK(!has(marks, "heap-buffer-overflow"));
  CHECK(has(hints, "Which length has L"));
  CHECK(has(hints, "heap-buffer-overflow"));
  for (const char* words : {"L is not divided", "expected 161", "point-yours.png"}) {
    CAPTURE(words);
    CHECK(!has(marks, words));
    CHECK(!has(hints, words));
    CHECK(has(full, words));
  }
}

TEST_CASE("A submission that is not judged to the end says so") {
  const InLanguage english("en");
  const std::string page = submission_page(example_run(), unjudged_submission());
  CHECK(has(page, "no final mark"));
  CHECK(has(page, "nobody loses points"));
  CHECK(!has(submission_page(example_run(), right_submission()), "no final mark"));
}

TEST_CASE("In Greek nothing of the page is English") {
  const InLanguage greek("el");
  const std::string page = submission_page(example_run(), wrong_submission());
  CHECK(has(page, R"(<html lang="el">)"));
  CHECK(has(page, "Σημειακό φως"));
  CHECK(has(page, "η σκηνή της διάλεξης"));
  for (const char* english : {"the lecture", "points", "Where", "What", "not right"}) {
    CAPTURE(english);
    const std::string body = page.substr(page.find("<body>"));
    CHECK(!has(body.substr(0, body.find("<pre")), english));
  }
}

TEST_CASE("The numbers of a class") {
  const InLanguage english("en");
  const std::vector<Summary> all = {summarize(right_submission()), summarize(wrong_submission()),
                                    summarize(unjudged_submission())};
  const ClassStatistics numbers = statistics_of(all);
  CHECK(numbers.submissions == 3);
  CHECK(numbers.settled == 2);
  CHECK(numbers.all_right == 1);
  CHECK(*numbers.mean == (10000 + 3750) / 2.0);
  CHECK(*numbers.median == (10000 + 3750) / 2.0);
  CHECK(numbers.tenths == std::array<int, 10>{0, 0, 0, 1, 0, 0, 0, 0, 0, 1});
  REQUIRE(numbers.stages.size() == 5);
  CHECK(numbers.stages[2].all_right == 2);
  CHECK(numbers.stages[2].partly == 1);
  CHECK(numbers.stages[4].not_judged == 1);
  CHECK(numbers.stages[4].mean == (2000 + 1500) / 2.0);
  // The carried mistake counts once; what has no name counts by its kind.
  REQUIRE(numbers.mistakes.size() == 3);
  for (const MistakeCount& one : numbers.mistakes) CHECK(one.submissions == 1);
  CHECK(statistics_of({}).submissions == 0);
  CHECK(!statistics_of({}).mean);
}

TEST_CASE("The page of a class of none, of one and of many") {
  const InLanguage english("en");
  CHECK(has(class_page(example_run(), {}), "There are no submissions."));
  CHECK(!has(class_page(example_run(), {}), "<table"));
  const std::string one = class_page(example_run(), std::vector{summarize(wrong_submission())});
  CHECK(has(one, R"(href="submissions/nikos-georgiou/index.html")"));
  CHECK(has(one, "37.5 / 100"));
  std::vector<Summary> all;
  all.reserve(2000);
  for (int i = 0; i < 2000; ++i) all.push_back(summarize(example_submission(i)));
  CHECK(class_page(example_run(), all).size() < std::size_t{4} * 1024 * 1024);
}

TEST_CASE("Only the files that are asked for, in a folder of their own") {
  const InLanguage english("en");
  const fos::Folder folder;
  const fs::path out = folder.path / "a class";
  ReportSettings settings;
  settings.formats = {std::begin(report_formats), std::end(report_formats)};
  const auto refused = write_submission_files(out, example_run(), unjudged_submission(), settings);
  CHECK(refused.size() == 3);
  for (const char* name :
       {"index.html", "results.json", "github-output.txt", "github-summary.md", "junit.xml"}) {
    CHECK(fs::file_size(out / "submissions" / "eleni" / name) > 0);
  }
  const std::vector<Summary> all = {summarize(unjudged_submission())};
  CHECK(write_class_files(out, example_run(), all, settings).size() == 2);
  for (const char* name : {"index.html", "grades.csv", "moodle.csv"}) {
    CHECK(fs::file_size(out / name) > 0);
  }
  CHECK(contents(out / "eclass.csv").empty());

  const fs::path few = folder.path / "few";
  settings.formats = {ReportFormat::csv};
  write_submission_files(few, example_run(), right_submission(), settings);
  write_class_files(few, example_run(), all, settings);
  CHECK(!fs::exists(few / "index.html"));
  CHECK(fs::exists(few / "grades.csv"));
}

TEST_CASE("An id that would leave the folder is refused") {
  const fos::Folder folder;
  for (const char* id : {"", ".", "..", "../x", "a/b", "A", "a\n", "α", "a b"}) {
    CAPTURE(id);
    SubmissionResult one = right_submission();
    one.id = id;
    CHECK_THROWS_AS(write_submission_files(folder.path, example_run(), one, {}), fos::FileError);
  }
  CHECK(folder.entries() == 0);
  CHECK(submission_folder("x", "a-1._") == fs::path("x/submissions/a-1._"));
}

TEST_CASE("A folder that cannot be made is an error, not a crash") {
  const fos::Folder folder;
  std::ofstream(folder.path / "file") << "x";
  CHECK_THROWS_AS(write_class_files(folder.path / "file", example_run(), {}, {}), fos::FileError);
}

TEST_CASE("Formats by name") {
  for (const ReportFormat format : report_formats) CHECK(report_format(name(format)) == format);
  CHECK(!report_format("pdf"));
}
