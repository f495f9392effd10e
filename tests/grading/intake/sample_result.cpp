#include "sample_result.hpp"

namespace fos::grading {

SubmissionResult sample_result(const std::string& id) {
  SubmissionResult result;
  result.id = id;
  result.name = "Νίκος \"</script>\" =HYPERLINK()\r\n\t\xE2\x80\xA8🎓";
  result.username = "nikos";
  result.email = "nikos@x.gr";
  result.source = "a/b.zip";
  result.key = "0123456789abcdef";
  result.box = "bubblewrap";
  result.seed = 0xFFFFFFFFFFFFFFFFULL;
  result.notes = {"", "\xFF\x80 no UTF-8 \xC3", std::string("nul \0 in it", 11)};
  result.status = Status::failed;
  for (const char* name : {"flat_color", "ambient", "point", "directional", "combined"}) {
    StageResult stage;
    stage.stage = name;
    stage.status = Status::failed;
    stage.cause = Cause::crashed;
    stage.points = 1250;
    stage.most = 3000;
    for (int i = 0; i < 20; ++i) {
      CheckResult check;
      check.part = parts[i % 3];
      check.words_en = "the lecture's scene, a light from each of its sides";
      check.words_el = "η σκηνή του μαθήματος, με φως από κάθε πλευρά της";
      check.status = Status::passed;
      check.cause = Cause::wrong_pixels;
      check.passed = i;
      check.things = 20;
      check.points = 150;
      check.most = 400;
      check.why = "column 300, row 349: 12, 34, 56 instead of 78, 90, 12";
      stage.checks.push_back(check);
    }
    stage.mistake = "L_not_normalized + N_reversed";
    stage.advice = "Which length has L?\nSee the slide.";
    stage.carried = true;
    stage.compiler = std::string(2000, 'c') + "\x1B[31m\xCE";
    stage.program = "::error::passed 3/3";
    stage.sanitizer = "point.cpp:12";
    stage.cpu_seconds = 0.1;
    stage.pictures = {"point-yours.png", "point-expected.png"};
    result.stages.push_back(stage);
  }
  result.overrides = {{"point", 3000, "by hand"}, {"", -100, ""}};
  return result;
}

}  // namespace fos::grading
