#include "diagnosis.hpp"

namespace fos {
namespace {

std::string where(const MistakeMade& finding) {
  std::string name = say(misconception(finding.mistake).name);
  if (finding.where == Where::point_lights) return say(text::diagnosis_point, {name});
  if (finding.where == Where::directional_lights) return say(text::diagnosis_directional, {name});
  return name;
}

void add_question(std::vector<std::string>& lines, const MistakeMade& finding,
                  const std::string& indent) {
  const Misconception& mistake = misconception(finding.mistake);
  lines.push_back(indent + say(mistake.question));
  lines.push_back(indent + say(text::diagnosis_look, {say(mistake.look)}));
}

void add_words(std::vector<std::string>& lines, const std::vector<MistakeMade>& findings,
               const std::string& indent) {
  for (const MistakeMade& finding : findings) {
    lines.push_back(indent + where(finding));
    add_question(lines, finding, indent + "  ");
  }
}

}  // namespace

std::string names(const Diagnosis& diagnosis) {
  std::string words;
  const auto add = [&](std::string_view before, const MistakeMade& made) {
    words.append(words.empty() ? "" : before).append(where(made));
  };
  for (const MistakeMade& made : diagnosis.certain) add("; ", made);
  for (std::size_t i = 0; i < diagnosis.one_of.size(); ++i) {
    std::string before = i == 0 ? "; " : " " + say(text::diagnosis_or) + " ";
    for (const MistakeMade& made : diagnosis.one_of[i]) {
      add(before, made);
      before = " + ";
    }
  }
  return words;
}

std::vector<std::string> questions(const Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  for (const MistakeMade& made : diagnosis.certain) add_question(lines, made, "");
  for (const auto& each : diagnosis.one_of) {
    for (const MistakeMade& made : each) add_question(lines, made, "");
  }
  return lines;
}

std::vector<std::string> describe(const Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  add_words(lines, diagnosis.certain, "");
  if (diagnosis.one_of.empty()) return lines;
  lines.push_back(
      say(diagnosis.certain.empty() ? text::diagnosis_one_of : text::diagnosis_and_one_of));
  for (std::size_t i = 0; i < diagnosis.one_of.size(); ++i) {
    if (i > 0) lines.push_back(say(text::diagnosis_or));
    add_words(lines, diagnosis.one_of[i], "  ");
  }
  return lines;
}

}  // namespace fos
