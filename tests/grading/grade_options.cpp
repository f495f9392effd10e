#include "grade_options.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>

#include "fos/text.hpp"

namespace fos::grading {
namespace {

template <typename Number>
Number number(const std::string& option, const std::string& word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw UsageError(say(text::grade_bad_number, {option, word}));
  }
  return value;
}

std::vector<std::string> parts_of_list(const std::string& list) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    parts.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<const Stage*> stages_named(const std::string& list) {
  std::vector<const Stage*> named;
  const std::vector<std::string> words = parts_of_list(list);
  for (const std::string& word : words) {
    if (std::none_of(std::begin(stages), std::end(stages),
                     [&](const Stage& each) { return each.id == word; })) {
      throw UsageError(say(text::grade_no_such_stage, {word}));
    }
  }
  for (const Stage& stage : stages) {
    if (std::find(words.begin(), words.end(), stage.id) != words.end()) named.push_back(&stage);
  }
  return named;
}

std::set<ReportFormat> formats_named(const std::string& list) {
  std::set<ReportFormat> formats;
  for (const std::string& word : parts_of_list(list)) {
    const auto format = report_format(word);
    if (!format) throw UsageError(say(text::grade_no_such_format, {word}));
    formats.insert(*format);
  }
  return formats;
}

Feedback feedback_named(const std::string& word) {
  for (const Feedback each : {Feedback::marks, Feedback::hints, Feedback::full}) {
    if (name(each) == word) return each;
  }
  throw UsageError(say(text::grade_no_such_feedback, {word}));
}

Level level_or_throw(const std::string& word) {
  const auto level = level_named(word);
  if (!level) throw UsageError(say(text::grade_no_such_box, {word}));
  return *level;
}

/// "2/5"
void take_part(GradeOptions& options, const std::string& word) {
  const std::size_t slash = std::min(word.find('/'), word.size());
  const std::string of = slash < word.size() ? word.substr(slash + 1) : "";
  options.part = number<unsigned>("--part", word.substr(0, slash));
  options.parts = number<unsigned>("--part", of);
  if (options.part < 1 || options.part > options.parts) {
    throw UsageError(say(text::grade_bad_part, {word}));
  }
}

/// What is left over is what is graded, or merged.
void take_paths(GradeOptions& options, const std::vector<std::string>& paths, bool merge) {
  if (merge) {
    if (paths.empty()) throw UsageError(say(text::grade_nothing_to_merge));
    options.merged.assign(paths.begin(), paths.end());
  } else {
    if (paths.size() != 1) throw UsageError(say(text::grade_one_path));
    options.path = paths.front();
  }
  if (options.output.empty() && !options.list) throw UsageError(say(text::grade_no_output));
}

}  // namespace

GradeOptions parse_grade_options(const std::vector<std::string>& arguments) {
  GradeOptions options;
  const std::map<std::string, std::function<void(const std::string&)>> with_value = {
      {"--output", [&](const std::string& value) { options.output = value; }},
      {"--root", [&](const std::string& value) { options.root = value; }},
      {"--build", [&](const std::string& value) { options.build = value; }},
      {"--part", [&](const std::string& value) { take_part(options, value); }},
      {"--jobs",
       [&](const std::string& value) { options.jobs = number<unsigned>("--jobs", value); }},
      {"--seed",
       [&](const std::string& value) { options.seed = number<std::uint64_t>("--seed", value); }},
      {"--stages", [&](const std::string& value) { options.stages = stages_named(value); }},
      {"--format", [&](const std::string& value) { options.formats = formats_named(value); }},
      {"--feedback", [&](const std::string& value) { options.feedback = feedback_named(value); }},
      {"--roster", [&](const std::string& value) { options.roster = value; }},
      {"--overrides", [&](const std::string& value) { options.overrides = value; }},
      {"--box", [&](const std::string& value) { options.box = level_or_throw(value); }},
  };
  std::vector<std::string> paths;
  bool merge = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const std::size_t equals = argument.starts_with("--") ? argument.find('=') : std::string::npos;
    const auto option = with_value.find(argument.substr(0, equals));
    if (argument == "--unsafe") {
      options.unsafe = true;
    } else if (argument == "--one") {
      options.one = true;
    } else if (argument == "--list") {
      options.list = true;
    } else if (argument == "--merge") {
      merge = true;
    } else if (option != with_value.end()) {
      if (equals == std::string::npos && i + 1 == arguments.size()) {
        throw UsageError(say(text::grade_needs_value, {argument}));
      }
      option->second(equals == std::string::npos ? arguments[++i] : argument.substr(equals + 1));
    } else if (argument.starts_with("--")) {
      throw UsageError(say(text::grade_no_such_option, {argument}));
    } else {
      paths.push_back(argument);
    }
  }
  take_paths(options, paths, merge);
  if (options.root.empty() || options.build.empty()) throw UsageError("--root, --build");
  if (options.stages.empty()) {
    for (const Stage& stage : stages) options.stages.push_back(&stage);
  }
  if (options.formats.empty()) options.formats = {ReportFormat::html, ReportFormat::csv};
  return options;
}

}  // namespace fos::grading
