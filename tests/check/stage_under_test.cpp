// A stage put to its test: FOS_STAGE names it, and FOS_PROGRAM the program, a lab, its solution, or
// a variation of it.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "catch2.hpp"
#include "examine.hpp"

using namespace fos;

namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  REQUIRE(value != nullptr);
  return value;
}

Findings examined() {
  const std::string id = variable("FOS_STAGE");
  const auto stage = std::find_if(std::begin(stages), std::end(stages),
                                  [&](const Stage& each) { return each.id == id; });
  REQUIRE(stage != std::end(stages));
  return examine(Questions(*stage), variable("FOS_PROGRAM"), patient_limits());
}

}  // namespace

TEST_CASE("the stage does all that is asked", "[stage]") {
  const Findings findings = examined();
  CHECK(findings.things > 10);
  for (const Finding& finding : findings.list) {
    INFO(finding.words << '\n' << finding.why);
    CHECK(finding.outcome == Outcome::passed);
  }
  if (!findings.note.empty()) WARN(findings.note);
}

TEST_CASE("an unwritten stage does nothing of what is asked", "[stub]") {
  const Findings findings = examined();
  for (const Finding& finding : findings.list) {
    INFO(finding.words);
    CHECK(finding.outcome == Outcome::failed);
    CHECK(finding.passed == 0);
  }
}
