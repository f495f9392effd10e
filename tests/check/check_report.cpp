#include "check_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "fos/text.hpp"

namespace fos {
namespace {

std::string mark(Outcome outcome, const Paint& paint) {
  return outcome == Outcome::passed   ? paint.green("✓")
         : outcome == Outcome::failed ? paint.red("✗")
                                      : paint.dim("·");
}

/// 17.5, or 20 where it is whole.
std::string points(int tenths) {
  return tenths % 10 == 0 ? std::to_string(tenths / 10)
                          : fmt::format("{}.{}", tenths / 10, tenths % 10);
}

std::string line(const Finding& finding, const Paint& paint) {
  std::string words = finding.words;
  if (finding.things > 1 && finding.passed < finding.things) {
    words +=
        " " + say(text::check_of, {std::to_string(finding.passed), std::to_string(finding.things)});
  }
  const std::string text = wrapped(words, 4);
  return "  " + mark(finding.outcome, paint) + text.substr(3);
}

bool is_untouched(const Findings& findings) {
  return findings.passed == 0 && findings.shown && findings.shown->verdict.unwritten.pixels > 0;
}

std::string padded(const std::string& text, int columns) {
  return text + std::string(static_cast<std::size_t>(std::max(0, columns - columns_of(text))), ' ');
}

}  // namespace

std::string stage_file(const Stage& stage) {
  return fmt::format("labs/lecture{:02}/{}.cpp", stage.lecture, stage.id);
}

const Finding* first_failure(const Findings& findings) {
  const auto first =
      std::find_if(findings.list.begin(), findings.list.end(),
                   [](const Finding& finding) { return finding.outcome == Outcome::failed; });
  return first == findings.list.end() || is_untouched(findings) ? nullptr : &*first;
}

std::string summary(const Findings& findings) {
  return say(text::check_points,
             {std::to_string(findings.passed), std::to_string(findings.things),
              points(findings.tenths()), std::to_string(findings.stage->points)});
}

std::string describe(const Findings& findings, const Paint& paint) {
  const Stage& stage = *findings.stage;
  std::string out = paint.bold(std::string(stage.id)) + " · " + say(stage.name) + "\n";
  for (const Finding& finding : findings.list) out += line(finding, paint);
  const std::string sum = summary(findings);
  out += (findings.passes() ? paint.green(sum) : paint.bold(sum)) + "\n";
  if (!findings.note.empty()) out += "\n" + wrapped(findings.note);
  const Finding* first = first_failure(findings);
  if (first == nullptr) return out;
  out += "\n" + paint.red("✗") + wrapped(first->words, 2).substr(1) + wrapped(first->why, 2);
  if (!findings.printed.empty()) {
    out += wrapped(say(text::check_printed), 2) + wrapped(findings.printed.substr(0, 300), 4);
  }
  return out;
}

std::string next_step(const Findings& findings) {
  const Stage& stage = *findings.stage;
  if (is_untouched(findings)) {
    return wrapped(say(text::check_unwritten_stage, {stage_file(stage)})) +
           wrapped(say(text::check_ask_hint, {stage.id}));
  }
  if (!findings.passes()) return wrapped(say(text::check_ask_hint, {stage.id}));
  const auto next = std::find_if(std::begin(stages), std::end(stages),
                                 [&](const Stage& each) { return each.id == stage.id; }) +
                    1;
  return wrapped(next == std::end(stages)
                     ? say(text::check_last_stage)
                     : say(text::check_next_stage, {next->id, stage_file(*next)}));
}

std::string overview(std::span<const StageResult> results, const Paint& paint) {
  std::string out;
  int tenths = 0;
  int done = 0;
  const StageResult* next = nullptr;
  for (const StageResult& result : results) {
    const Stage& stage = *result.stage;
    const bool passes = result.findings && result.findings->passes();
    const int earned = result.findings ? result.findings->tenths() : 0;
    tenths += earned;
    done += passes ? 1 : 0;
    if (!passes && next == nullptr) next = &result;
    const std::string word = !result.findings                 ? say(text::check_does_not_build)
                             : is_untouched(*result.findings) ? say(text::check_not_begun)
                                                              : result.mistake;
    std::string row = fmt::format("{}{}{:>5} / {}", padded(std::string(stage.id), 14),
                                  padded(say(stage.name), 24), points(earned), stage.points);
    if (!word.empty()) row = padded(row, 50) + word;
    out += "  " + mark(passes ? Outcome::passed : Outcome::failed, paint) + " " + row + "\n";
  }
  int all = 0;  // of the stages whose file is missing too
  for (const Stage& stage : stages) all += stage.points;
  constexpr int bar = 40;
  const int full = bar * tenths / std::max(1, 10 * all);
  out += "\n  [" + paint.green(std::string(static_cast<std::size_t>(full), '#')) +
         std::string(static_cast<std::size_t>(bar - full), '.') + "] " +
         say(text::check_course, {std::to_string(done), std::to_string(std::size(stages)),
                                  points(tenths), std::to_string(all)}) +
         "\n\n";
  if (next == nullptr && results.size() < std::size(stages)) return out;
  if (next == nullptr) return out + wrapped(say(text::check_course_done));
  return out + wrapped(say(text::check_course_next, {next->stage->id, stage_file(*next->stage)}));
}

}  // namespace fos
