#include <algorithm>

#include "escape.hpp"
#include "platforms.hpp"

namespace fos::grading {
namespace {

/// The stages of the class in the order in which they come, each once: a submission need not have
/// all of them.
std::vector<std::string> stages_of(std::span<const Summary> all) {
  std::vector<std::string> out;
  for (const Summary& one : all) {
    for (const StageSummary& stage : one.stages) {
      if (std::find(out.begin(), out.end(), stage.stage) == out.end()) out.push_back(stage.stage);
    }
  }
  return out;
}

std::string stage_cell(const Summary& one, const std::string& id) {
  for (const StageSummary& stage : one.stages) {
    if (stage.stage != id) continue;
    const bool marked = std::any_of(one.overrides.begin(), one.overrides.end(),
                                    [&](const Override& own) { return own.stage == id; });
    return stage.status == Status::not_judged && !marked ? "" : points_text(stage.points);
  }
  return "";
}

}  // namespace

std::string grades_csv(std::span<const Summary> all) {
  const std::vector<std::string> stages = stages_of(all);
  std::string out = "id,name,username,email,status";
  for (const std::string& stage : stages) out += "," + csv_cell(stage);
  out += ",total,maximum,mistakes,overrides\n";
  for (const Summary& one : all) {
    for (const std::string& cell : {one.id, one.name, one.username, one.email}) {
      out += csv_cell(cell) + ",";
    }
    out += name(one.status);
    for (const std::string& stage : stages) out += "," + stage_cell(one, stage);
    out += "," + (is_settled(one) ? points_text(one.points) : "") + "," + points_text(one.most);
    std::string mistakes;
    for (const StageSummary& stage : one.stages) {
      if (stage.mistake.empty()) continue;
      mistakes += (mistakes.empty() ? "" : " · ") + stage.stage + ": " + stage.mistake;
    }
    std::string reasons;
    for (const Override& own : one.overrides) {
      reasons += (reasons.empty() ? "" : " · ") + (own.stage.empty() ? "*" : own.stage) + ": " +
                 points_text(own.points) + ": " + own.reason;
    }
    out += "," + csv_cell(mistakes) + "," + csv_cell(reasons) + "\n";
  }
  return out;
}

}  // namespace fos::grading
