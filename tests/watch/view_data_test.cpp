#include "view_data.hpp"

#include <algorithm>
#include <limits>

#include "catch2.hpp"

using namespace fos;

namespace {

/// The stage `point` on the small scene `inside`, with some wrong pixels.
struct Sample {
  Findings findings;
  View view;

  explicit Sample(const std::vector<Pixel>& wrong) {
    const auto judge = std::make_shared<const Judge>(
        reference::read_reference(FOS_REFERENCE_DATA "/inside.ref"), ambient_term | point_term);
    const auto frame = std::make_shared<Frame>(judge->exact());
    for (const auto& [column, row] : wrong) {
      const int index = row * frame->header.width + column;
      frame->channels[3 * static_cast<std::size_t>(index)] = 1000.5L;
    }
    findings.stage = &*std::find_if(std::begin(stages), std::end(stages),
                                    [](const Stage& stage) { return stage.id == "point"; });
    findings.list.push_back({"every </script> pixel", Outcome::failed, 0, 1, "why \"so\"", {}});
    findings.things = 1;
    findings.passed = wrong.empty() ? 1 : 0;
    findings.shown = {"inside", judge, frame, judge->judge(*frame)};
    view.stage = findings.stage;
    view.id = "17";
    view.findings = &findings;
    view.difference = difference(*judge, *frame);
    view.pictures = {"PNG", "PNG", "PNG"};
    view.scene_file = "build/images/point-view.scene";
  }
};

bool has(const std::string& script, const std::string& part) {
  return script.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the page is told of a check") {
  Sample sample({{3, 2}});
  sample.view.parts = {0, 4};
  sample.view.advice = "L is \"reversed\"\n  </script>";
  const std::string script = view_script(sample.view);
  CHECK(script.starts_with("fosView({"));
  CHECK(script.ends_with("});\n"));
  for (const char* part : {R"("id": "17")", R"("stage": "point")", R"("outcome": "fails")",
                           R"("words": "every </script> pixel")", R"(why \"so\")",
                           R"("advice": "L is \"reversed\"\u000a  </script>")", R"("column": 3)",
                           R"("row": 2)", R"("data:image/png;base64,UE5H")", R"("parts": [0, 4])",
                           R"("./lab explain point {0} {1} --scene build/images/point-view.scene")",
                           R"(column {0}, row {1})"}) {
    INFO(script);
    CHECK(has(script, part));
  }
}

TEST_CASE("a check that passes, and a stage that does not compile") {
  const Sample right({});
  CHECK(has(view_script(right.view), R"("outcome": "passes")"));
  CHECK(has(view_script(right.view), R"("advice": "")"));
  CHECK(values_scripts(*right.findings.shown, "17").empty());
  View view;
  view.stage = right.view.stage;
  view.compiler = "error: <b>";
  const std::string script = view_script(view);
  CHECK(has(script, R"("outcome": "no_build")"));
  CHECK(has(script, R"("first": "error: <b>")"));
  CHECK(has(script, R"("pictures": null)"));
}

TEST_CASE("the values of wrong pixels, before rounding") {
  const Sample sample({{3, 2}});
  const auto parts = values_scripts(*sample.findings.shown, "17");
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].number == 0);
  CHECK(parts[0].script.starts_with("fosValues({\"id\": \"17\",\n\"part\": 0,\n\"data\": \""));
  // 4 bytes for the index, 6 floats of 4: 28 bytes, 40 letters.
  const std::size_t begin = parts[0].script.find("data") + 8;
  const std::string data = parts[0].script.substr(begin, parts[0].script.rfind('"') - begin);
  CHECK(data.size() == 40);
  CHECK(data.ends_with("="));
  // 1000.5f is 0x447a2000: after the index, and three bytes 0 of it, 00 20 7a 44.
  const int index = 2 * sample.findings.shown->frame->header.width + 3;
  CHECK(index < 256);
  CHECK(data.substr(2, 8) == "AAAAAgek");
}

TEST_CASE("a part holds few enough pixels") {
  CHECK(rows_of_part(600) * 600 <= 20'000);
  CHECK(rows_of_part(1) == 20'000);
  CHECK(rows_of_part(16'384) == 1);
  CHECK(rows_of_part(1'000'000) == 1);
}

TEST_CASE("the newest check by its id") {
  CHECK(now_script("17", stages[0]) == "fosNow(\"17\", \"flat_color\");\n");
}
