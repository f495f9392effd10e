// Points and names of results, and results as JSON.
#include "result.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <limits>
#include <random>

#include "catch2.hpp"
#include "result_json.hpp"
#include "sample_result.hpp"

using namespace fos::grading;

namespace {

/// With the right sum, so that what else is wrong must be found.
std::string summed(std::string json) {
  const std::size_t line = json.find('\n');
  const std::size_t at = json.find(R"("sum":")");
  if (line == std::string::npos || at > line) return json;
  const std::string_view rest = std::string_view(json).substr(line + 1);
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(rest.data()), static_cast<uInt>(rest.size()));
  return json.replace(at + 7, 8, fmt::format("{:08x}", sum));
}

}  // namespace

TEST_CASE("points as people write them") {
  CHECK(points_text(0) == "0");
  CHECK(points_text(1200) == "12");
  CHECK(points_text(1250) == "12.5");
  CHECK(points_text(1205) == "12.05");
  CHECK(points_text(5) == "0.05");
  CHECK(points_text(-5) == "-0.05");
  CHECK(points_text(-120) == "-1.2");
  CHECK(points_text(std::numeric_limits<int>::min()) == "-21474836.48");
}

TEST_CASE("overrides: of a stage, of the whole, the last one") {
  SubmissionResult result = sample_result("a");
  result.overrides.clear();
  CHECK(result.points() == 5 * 1250);
  CHECK(result.most() == 5 * 3000);
  result.overrides = {{"point", 100, ""}, {"point", 200, ""}, {"no stage", 9999, ""}};
  CHECK(points_of(result, result.stages[2]) == 200);
  CHECK(result.points() == 4 * 1250 + 200);
  result.overrides.push_back({"", 7, ""});
  CHECK(result.points() == 7);
  CHECK(points_of(result, result.stages[2]) == 200);
}

TEST_CASE("names are all different") {
  std::string all;
  for (int i = 0; i <= static_cast<int>(Cause::infrastructure); ++i) {
    const std::string one = "," + std::string(name(static_cast<Cause>(i))) + ",";
    CHECK(all.find(one) == std::string::npos);
    all += one;
  }
  CHECK(name(Status::not_judged) == "not_judged");
  CHECK(name(Part::relations) == "relations");
  CHECK(name(Feedback::hints) == "hints");
}

TEST_CASE("a result comes back as it was, whatever is in it") {
  const SubmissionResult result = sample_result("nikos-1");
  const std::string json = to_json(result);
  const SubmissionResult back = result_from_json(json);
  CHECK(to_json(back) == json);
  CHECK(back.id == result.id);
  CHECK(back.name == result.name);
  CHECK(back.seed == result.seed);
  CHECK(back.notes == result.notes);
  CHECK(back.status == result.status);
  REQUIRE(back.stages.size() == 5);
  CHECK(back.stages[0].compiler == result.stages[0].compiler);
  CHECK(back.stages[0].cpu_seconds == result.stages[0].cpu_seconds);
  CHECK(back.stages[0].checks[4].part == result.stages[0].checks[4].part);
  CHECK(back.stages[4].pictures == result.stages[4].pictures);
  CHECK(back.overrides[1].points == -100);
  CHECK(back.points() == result.points());

  SubmissionResult odd = result;
  odd.stages[0].cpu_seconds = std::numeric_limits<double>::quiet_NaN();
  CHECK(result_from_json(to_json(odd)).stages[0].cpu_seconds == 0);

  Run run{"Γραφικά \xFF",         "1.2", 42, "landlock", Feedback::marks,
          "2025-01-01T10:00:00Z", 2,     5,  {"a", "b"}, true};
  const Run run_back = run_from_json(to_json(run));
  CHECK(run_back.title == run.title);
  CHECK(run_back.seed == 42);
  CHECK(run_back.part == 2);
  CHECK(run_back.finished == run.finished);
  CHECK(run_back.feedback == Feedback::marks);
  CHECK(to_json(run_back) == to_json(run));
}

TEST_CASE("what is not quite a result is refused") {
  const std::string good = to_json(sample_result("a"));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    REQUIRE(bad.find(from) != std::string::npos);
    return summed(bad.replace(bad.find(from), from.size(), to));
  };
  CHECK_NOTHROW(result_from_json(with(R"("nikos")", R"("maria")")));
  CHECK_THROWS_WITH(result_from_json(good + " "), ContainsSubstring("damaged"));
  for (const std::string& bad : {with(R"("format":1)", R"("format":2)"),
                                 with(R"("id":"a")", R"("id":"../a")"),
                                 with(R"("id":"a")", R"("id":"")"),
                                 with(R"("username")", R"("user")"),
                                 with(R"("seed": 1)", R"("seed": -1)"),
                                 with(R"("seed": 1)", R"("seed": 99)"),
                                 with(R"("status":"failed")", R"("status":"fine")"),
                                 with(R"("points": 1250)", R"("points": 12.5)"),
                                 with(R"("points": 1250)", R"("points": 99999999999)"),
                                 with(R"("passed": 0)", R"("passed": 21)"),
                                 with(R"("carried": true)", R"("carried": 1)"),
                                 with("point-yours.png", "../../index.html"),
                                 with(R"("bytes")", R"("bits")"),
                                 with(R"("box")", R"("more": 1, "box")"),
                                 with("{", "[{"),
                                 with(R"("email")", R"("name")"),
                                 std::string(),
                                 std::string("null"),
                                 std::string("{}"),
                                 summed(good + "x")}) {
    INFO(bad.substr(0, 200));
    CHECK_THROWS_AS(result_from_json(bad), JsonError);
  }
  CHECK_THROWS_AS(result_from_json(std::string(1'000'000, '[')), JsonError);
  CHECK_THROWS_AS(run_from_json(good), JsonError);
  std::mt19937 random(2);
  SubmissionResult small = sample_result("a");
  small.stages.resize(1);
  small.stages[0].checks.resize(1);
  small.stages[0].compiler.clear();
  const std::string json = to_json(small);
  for (std::size_t size = 0; size + 1 < json.size(); ++size) {  // the last byte is the line's end
    CHECK_THROWS_AS(result_from_json(summed(json.substr(0, size))), JsonError);
  }
  for (int i = 0; i < 20'000; ++i) {
    std::string bad = json;
    for (auto flips = 1 + random() % 3; flips > 0; --flips) {
      bad[random() % bad.size()] = static_cast<char>(random() % 256);
    }
    try {
      result_from_json(summed(bad));
    } catch (const JsonError&) {
    }
  }
}
