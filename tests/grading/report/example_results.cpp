#include "example_results.hpp"

#include <fmt/core.h>

namespace fos::grading {
namespace {

StageResult stage(const std::string& id, int most, Status status) {
  StageResult out;
  out.stage = id;
  out.status = status;
  out.most = most * 100;
  out.points = status == Status::passed ? out.most : 0;
  const auto add = [&](Part part, const char* en, const char* el, int things, int share) {
    CheckResult check;
    check.part = part;
    check.words_en = en;
    check.words_el = el;
    check.status = status;
    check.things = things;
    check.passed = status == Status::passed ? things : 0;
    check.most = out.most * share / 100;
    check.points = status == Status::passed ? check.most : 0;
    if (status == Status::failed) check.cause = Cause::wrong_pixels;
    out.checks.push_back(check);
  };
  add(Part::checks, "the lecture's scene", "η σκηνή της διάλεξης", 1, 40);
  add(Part::checks, "a light behind the surface adds nothing",
      "ένα φως πίσω από την επιφάνεια δεν προσθέτει τίποτα", 4, 20);
  add(Part::scenes, "scenes with several spheres", "σκηνές με πολλές σφαίρες", 6, 30);
  add(Part::relations, "the mirrored scene gives the mirrored picture",
      "η κατοπτρική σκηνή δίνει την κατοπτρική εικόνα", 1, 10);
  return out;
}

void pass_check(StageResult& out, std::size_t index, int passed) {
  CheckResult& check = out.checks[index];
  check.passed = passed;
  check.points = check.most * passed / check.things;
  if (passed == check.things) {
    check.status = Status::passed;
    check.cause = Cause::none;
  }
  out.points += check.points;
}

SubmissionResult named(const std::string& id, const std::string& name,
                       const std::string& username) {
  SubmissionResult out;
  out.id = id;
  out.name = name;
  out.username = username;
  out.email = username.empty() ? "" : username + "@example.org";
  out.source = "hand-ins.zip/" + name + ".zip";
  out.key = "5e1f09a2";
  out.box = "bubblewrap";
  out.seed = 20241125;
  out.status = Status::passed;
  return out;
}

}  // namespace

Run example_run() {
  return {"Computer Graphics, light", "1.0", 20241125, "bubblewrap", Feedback::full,
          "2024-11-25T10:00:00",      1,     1,        {},           false};
}

SubmissionResult right_submission() {
  SubmissionResult out = named("maria-papadopoulou", "Μαρία Παπαδοπούλου", "cs1234");
  for (const auto& [id, most] : {std::pair{"flat_color", 20},
                                 {"ambient", 10},
                                 {"point", 30},
                                 {"directional", 20},
                                 {"combined", 20}}) {
    out.stages.push_back(stage(id, most, Status::passed));
  }
  return out;
}

SubmissionResult wrong_submission() {
  SubmissionResult out = right_submission();
  out.id = "nikos-georgiou";
  out.name = "Georgiou, Nikos";
  out.username = "cs2345";
  out.email = "nikos@example.org";
  out.status = Status::failed;
  out.notes = {"point.cpp: found twice, in a/ and in b/: the one in a/ is graded"};

  StageResult& flat = out.stages[0] = stage("flat_color", 20, Status::failed);
  flat.cause = Cause::crashed;
  for (CheckResult& check : flat.checks) check.cause = Cause::crashed;
  flat.program = "row 17\nrow 18\n";
  flat.sanitizer = "heap-buffer-overflow in trace_ray, flat_color.cpp:31";

  StageResult& point = out.stages[2] = stage("point", 30, Status::failed);
  pass_check(point, 1, 3);
  pass_check(point, 3, 1);
  point.checks[0].why = "first wrong pixel: column 300, row 349: expected 161, came 255";
  point.mistake = "L is not divided by its length";
  point.advice = "Which length has L where the light is far away?\nSlide: the diffuse equation";
  point.pictures = {"point-yours.png", "point-expected.png", "point-difference.png"};

  StageResult& directional = out.stages[3] = stage("directional", 20, Status::failed);
  directional.cause = Cause::not_compiled;
  for (CheckResult& check : directional.checks) check.cause = Cause::not_compiled;
  directional.compiler = "directional.cpp:12:9: error: 'intensty' was not declared\n";

  StageResult& combined = out.stages[4] = stage("combined", 20, Status::failed);
  combined.points = 1500;
  combined.mistake = point.mistake;
  combined.carried = true;
  out.overrides = {{"directional", 500, "a typing error in the last minute"}};
  return out;
}

SubmissionResult unjudged_submission() {
  SubmissionResult out = right_submission();
  out.id = "eleni";
  out.name = "Eleni";
  out.username = "cs3456";
  out.email = "eleni@example.org";
  out.status = Status::not_judged;
  out.stages[4] = stage("combined", 20, Status::not_judged);
  out.stages[4].cause = Cause::infrastructure;
  for (CheckResult& check : out.stages[4].checks) check.cause = Cause::infrastructure;
  return out;
}

SubmissionResult hostile_submission(const std::string& text) {
  SubmissionResult out = wrong_submission();
  out.id = "hostile";
  out.name = out.username = out.email = out.source = out.key = out.box = text;
  out.notes = {text, text};
  for (Override& own : out.overrides) own.reason = text;
  out.overrides.push_back({text, 100, text});
  for (StageResult& one : out.stages) {
    one.stage = one.mistake = one.advice = one.compiler = one.program = one.sanitizer = text;
    one.pictures = {text, text, text};
    for (CheckResult& check : one.checks) check.words_en = check.words_el = check.why = text;
  }
  return out;
}

Run hostile_run(const std::string& text) {
  Run out = example_run();
  out.title = out.toolkit = out.box = text;
  return out;
}

const std::vector<std::string>& hostile_texts() {
  static const std::vector<std::string> texts = {
      "<script>hacked()</script>",
      R"("><img src=x onerror=hacked()>)",
      "' onmouseover='hacked()' x='",
      "` onmouseover=hacked() `",
      "</pre></details></td></table><b>bold</b>",
      "</style></script><script>hacked()</script>",
      "javascript:hacked()",
      "../../etc/passwd",
      R"(=HYPERLINK("http://evil.example","click"))",
      "+1+1",
      "-2+3+cmd|' /C calc'!A0",
      "@SUM(1+1)*cmd|' /C calc'!A0",
      "\t=1+1",
      "\r=1+1",
      "  =1+1",
      "a;=1+1",
      R"(a",=1+1)",
      "＝1+1",
      "\n::notice title=Autograding report::{\"totalPoints\":100,\"maxPoints\":100}",
      "::stop-commands::x",
      " \u200b::error::x :\u200b:warning:: ##[command]x #\u00ad#[error]x",
      "\033[2J\033[31mred\033[0m\033]8;;http://evil.example\033\\link\033]8;;\033\\ \007\010\x7f",
      "\u009b31m \u0085 \u0090q",
      "\u202Egnp.exe\u202C \u2066x\u2069 \u200F \uFEFF",
      "not UTF-8: \xC3\x28 \xFF\xFE \xED\xA0\x80 \xF4\x90\x80\x80 \xC0\xAF \xE2\x82",
      std::string("NUL: \0 and \x01\x02\x0B\x0C\x1F", 16),
      "forbidden in XML: \uFFFE \uFFFF ]]> <!--",
      R"(","score":100,"x":")",
      R"(\u0022,\"})",
      "| a | **bold** [link](javascript:hacked()) ![x](http://evil.example/x.png) `code` @octo",
      "\n# heading\n- item\n> quote\n```\n<b>x</b>\nhttp://evil.example www.evil.example",
      "{0} {1} {{}} %s",
      "&lt;script&gt; &#60;b&#62;",
      "7.5",
      "Grade :=>>100",
      "line\u2028line\u2029line"};
  return texts;
}

namespace {

/// A hostile text in every place that a student's words can be in; stages and pictures as they are.
SubmissionResult hostile_one(unsigned n) {
  const SubmissionResult wrong = wrong_submission();
  SubmissionResult out = hostile_submission(hostile_texts()[n / 4 % hostile_texts().size()]);
  out.id = fmt::format("s{:04}", n);
  for (std::size_t i = 0; i < out.stages.size(); ++i) {
    out.stages[i].stage = wrong.stages[i].stage;
    out.stages[i].pictures = wrong.stages[i].pictures;
  }
  return out;
}

}  // namespace

SubmissionResult example_submission(int index) {
  constexpr const char* first[] = {"Άννα",  "Γιώργος", "Ελένη",    "Κώστας", "Μαρία",
                                   "Νίκος", "Zoe",     "O'Connor", "Adèle",  "Ödön"};
  constexpr const char* last[] = {"Παπαδοπούλου",
                                  "Γεωργίου",
                                  "Smith",
                                  "Νικολάου",
                                  "Ιωάννου",
                                  "von der Leyen",
                                  "Καραγιάννη-Παπαδημητρίου"};
  constexpr const char* mistakes[] = {
      "L is not divided by its length", "N points inward: the spheres are lit from behind",
      "a negative cosine is not ignored", "a is missing, as if D had length 1"};
  const auto n = static_cast<unsigned>(index);
  if (n % 4 == 3) return hostile_one(n);
  SubmissionResult out = n % 3 == 0 ? right_submission() : wrong_submission();
  if (n % 31 == 30) out = unjudged_submission();
  out.id = fmt::format("s{:04}", index);
  out.name = fmt::format("{} {}", first[n * 7 % 10], last[n * 5 % 7]);
  out.username = fmt::format("cs{:04}", (n * 7919) % 10000);
  out.email = out.username + "@example.org";
  if (n % 3 != 1) out.overrides.clear();
  if (n % 5 != 1) out.notes.clear();
  if (n % 3 == 1) {
    out.stages[0] = stage("flat_color", 20, Status::passed);
    out.stages[2].mistake = mistakes[n / 3 % 4];
    out.stages[4].carried = n % 2 == 0;
  }
  if (n % 7 == 4) out.stages[3] = stage("directional", 20, Status::passed);
  return out;
}

}  // namespace fos::grading
