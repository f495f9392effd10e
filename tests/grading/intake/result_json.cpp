#include "result_json.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "encoding.hpp"
#include "file_names.hpp"

namespace fos::grading {
namespace {

using Written = nlohmann::ordered_json;  // in the order of result.hpp, for who reads the file
using Read = nlohmann::json;

// --- writing ---

Written text(const std::string& words) {
  if (is_utf8(words)) return words;
  return {{"bytes", *from_encoding("ISO-8859-1", words)}};
}

Written texts(const std::vector<std::string>& all) {
  Written out = Written::array();
  for (const std::string& words : all) out.push_back(text(words));
  return out;
}

Written written(const CheckResult& check) {
  return {{"part", name(check.part)},
          {"words_en", text(check.words_en)},
          {"words_el", text(check.words_el)},
          {"status", name(check.status)},
          {"cause", name(check.cause)},
          {"passed", check.passed},
          {"things", check.things},
          {"points", check.points},
          {"most", check.most},
          {"why", text(check.why)}};
}

Written written(const StageResult& stage) {
  Written checks = Written::array();
  for (const CheckResult& check : stage.checks) checks.push_back(written(check));
  return {{"stage", text(stage.stage)},
          {"status", name(stage.status)},
          {"cause", name(stage.cause)},
          {"points", stage.points},
          {"most", stage.most},
          {"checks", std::move(checks)},
          {"mistake", text(stage.mistake)},
          {"advice", text(stage.advice)},
          {"carried", stage.carried},
          {"compiler", text(stage.compiler)},
          {"program", text(stage.program)},
          {"sanitizer", text(stage.sanitizer)},
          {"cpu_seconds", std::isfinite(stage.cpu_seconds) ? stage.cpu_seconds : 0},
          {"pictures", texts(stage.pictures)}};
}

Written written(const Override& mine) {
  return {{"stage", text(mine.stage)}, {"points", mine.points}, {"reason", text(mine.reason)}};
}

// --- reading ---

[[noreturn]] void refuse(const std::string& why) { throw JsonError(why); }

std::string string_of(const Read& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_object() || value.size() != 1 || !value.contains("bytes") ||
      !value["bytes"].is_string())
    refuse("a text is none");
  std::string bytes;
  const auto characters = value["bytes"].get<std::string>();
  for (std::size_t i = 0; i < characters.size(); ++i) {
    // Valid UTF-8, as the parser sees to: characters up to U+00FF are one byte, or two.
    const auto first = static_cast<unsigned char>(characters[i]);
    if (first > 0xC3) refuse("bytes that are none");
    if (first >= 0x80) {
      const auto second = static_cast<unsigned char>(characters[++i]);
      bytes += static_cast<char>(((first & 3U) << 6U) | (second & 0x3FU));
    } else {
      bytes += static_cast<char>(first);
    }
  }
  return bytes;
}

template <class Number>
Number number_of(const Read& value, Number least, Number most) {
  if (!value.is_number_integer()) refuse("a number is none");
  if (value.is_number_unsigned()) {
    const auto number = value.get<std::uint64_t>();
    if (std::cmp_less(number, least) || std::cmp_greater(number, most)) refuse("out of range");
    return static_cast<Number>(number);
  }
  const auto number = value.get<std::int64_t>();
  if (std::cmp_less(number, least) || std::cmp_greater(number, most)) refuse("out of range");
  return static_cast<Number>(number);
}

constexpr int most_number = 1'000'000'000;
int count_of(const Read& value) { return number_of(value, 0, most_number); }
int points_from(const Read& value) { return number_of(value, -most_number, most_number); }

/// The enumerator of that name, of those from the first to the last.
template <class Enum>
Enum enum_of(const Read& value, Enum last) {
  const std::string wanted = string_of(value);
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    if (name(static_cast<Enum>(i)) == wanted) return static_cast<Enum>(i);
  }
  refuse("unknown: " + wanted);
}

/// An object of which each key is asked for, once.
class Keys {
 public:
  explicit Keys(const Read& object) : object_(object) {
    if (!object.is_object()) refuse("not an object");
  }
  const Read& operator[](const char* key) {
    const auto found = object_.find(key);
    if (found == object_.end()) refuse(std::string("no ") + key);
    ++asked_;
    return *found;
  }
  void end() const {
    if (asked_ != object_.size()) refuse("unknown keys");
  }

 private:
  const Read& object_;
  std::size_t asked_ = 0;
};

template <class Make>
auto list_of(const Read& value, const Make& make) {
  if (!value.is_array()) refuse("not a list");
  std::vector<decltype(make(value))> out;
  for (const Read& one : value) out.push_back(make(one));
  return out;
}

CheckResult check_of(const Read& value) {
  Keys keys(value);
  CheckResult check;
  check.part = enum_of(keys["part"], Part::relations);
  check.words_en = string_of(keys["words_en"]);
  check.words_el = string_of(keys["words_el"]);
  check.status = enum_of(keys["status"], Status::not_judged);
  check.cause = enum_of(keys["cause"], Cause::infrastructure);
  check.passed = count_of(keys["passed"]);
  check.things = count_of(keys["things"]);
  check.points = count_of(keys["points"]);
  check.most = count_of(keys["most"]);
  check.why = string_of(keys["why"]);
  keys.end();
  if (check.passed > check.things) refuse("more passed than there are");
  return check;
}

/// A file's name, and no path.
std::string file_name_of(const Read& value) {
  std::string file = string_of(value);
  if (file.empty() || file == "." || file == ".." || file.find('/') != std::string::npos ||
      file.find('\0') != std::string::npos)
    refuse("not a file's name");
  return file;
}

StageResult stage_of(const Read& value) {
  Keys keys(value);
  StageResult stage;
  stage.stage = string_of(keys["stage"]);
  stage.status = enum_of(keys["status"], Status::not_judged);
  stage.cause = enum_of(keys["cause"], Cause::infrastructure);
  stage.points = points_from(keys["points"]);
  stage.most = count_of(keys["most"]);
  stage.checks = list_of(keys["checks"], check_of);
  stage.mistake = string_of(keys["mistake"]);
  stage.advice = string_of(keys["advice"]);
  const Read& carried = keys["carried"];
  if (!carried.is_boolean()) refuse("carried is neither true nor false");
  stage.carried = carried.get<bool>();
  stage.compiler = string_of(keys["compiler"]);
  stage.program = string_of(keys["program"]);
  stage.sanitizer = string_of(keys["sanitizer"]);
  const Read& seconds = keys["cpu_seconds"];
  if (!seconds.is_number()) refuse("cpu_seconds is no number");
  stage.cpu_seconds = seconds.get<double>();
  stage.pictures = list_of(keys["pictures"], file_name_of);
  keys.end();
  return stage;
}

Override override_of(const Read& value) {
  Keys keys(value);
  Override mine;
  mine.stage = string_of(keys["stage"]);
  mine.points = points_from(keys["points"]);
  mine.reason = string_of(keys["reason"]);
  keys.end();
  return mine;
}

/// Parses, and lets the reader take what it wants: whatever goes wrong is a JsonError.
template <class Reader>
auto read_json(std::string_view json, const Reader& reader) {
  try {
    const Read value = Read::parse(json);
    Keys keys(value);
    if (count_of(keys["format"]) != json_format) refuse("another format");
    auto out = reader(keys);
    keys.end();
    return out;
  } catch (const Read::exception& error) {
    throw JsonError(error.what());
  }
}

ResultHead head_of(Keys& keys) {
  ResultHead head;
  head.id = string_of(keys["id"]);
  if (!is_safe_id(head.id)) refuse("not an id");
  head.key = string_of(keys["key"]);
  head.status = enum_of(keys["status"], Status::not_judged);
  return head;
}

/// CRC-32, in eight hexadecimal digits.
std::string sum_of(std::string_view bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return fmt::format("{:08x}", crc32_z(0, data, bytes.size()));
}

constexpr std::uint64_t most_seed = std::numeric_limits<std::uint64_t>::max();
constexpr unsigned most_parts = 1'000'000;

}  // namespace

std::string to_json(const SubmissionResult& result) {
  Written stages = Written::array();
  for (const StageResult& stage : result.stages) stages.push_back(written(stage));
  Written overrides = Written::array();
  for (const Override& mine : result.overrides) overrides.push_back(written(mine));
  const Written rest = {{"name", text(result.name)},        {"username", text(result.username)},
                        {"email", text(result.email)},      {"source", text(result.source)},
                        {"box", text(result.box)},          {"seed", result.seed},
                        {"notes", texts(result.notes)},     {"stages", std::move(stages)},
                        {"overrides", std::move(overrides)}};
  const std::string after = rest.dump(1).substr(2) + "\n";  // without its first line, the brace
  const Written head = {{"format", json_format},
                        {"id", text(result.id)},
                        {"key", text(result.key)},
                        {"status", name(result.status)},
                        {"sum", sum_of(after)}};
  std::string all = head.dump();
  all.pop_back();
  return all + ",\n" + after;
}

std::string to_json(const Run& run) {
  const Written all = {{"format", json_format},
                       {"title", text(run.title)},
                       {"toolkit", text(run.toolkit)},
                       {"seed", run.seed},
                       {"box", text(run.box)},
                       {"feedback", name(run.feedback)},
                       {"date", text(run.date)},
                       {"part", run.part},
                       {"parts", run.parts},
                       {"finished", run.is_finished ? texts(run.finished) : Written()}};
  return all.dump(1) + "\n";
}

ResultHead head_from_json(std::string_view json) {
  const std::size_t end = json.find('\n');
  if (end == std::string_view::npos || end == 0 || json[end - 1] != ',') refuse("no first line");
  return read_json(std::string(json.substr(0, end - 1)) + "}", [&](Keys& keys) {
    ResultHead head = head_of(keys);
    if (string_of(keys["sum"]) != sum_of(json.substr(end + 1))) refuse("damaged");
    return head;
  });
}

SubmissionResult result_from_json(std::string_view json) {
  head_from_json(json);
  return read_json(json, [](Keys& keys) {
    ResultHead head = head_of(keys);
    keys["sum"];
    SubmissionResult result;
    result.id = std::move(head.id);
    result.key = std::move(head.key);
    result.status = head.status;
    result.name = string_of(keys["name"]);
    result.username = string_of(keys["username"]);
    result.email = string_of(keys["email"]);
    result.source = string_of(keys["source"]);
    result.box = string_of(keys["box"]);
    result.seed = number_of<std::uint64_t>(keys["seed"], 0, most_seed);
    result.notes = list_of(keys["notes"], string_of);
    result.stages = list_of(keys["stages"], stage_of);
    result.overrides = list_of(keys["overrides"], override_of);
    return result;
  });
}

Run run_from_json(std::string_view json) {
  return read_json(json, [](Keys& keys) {
    Run run;
    run.title = string_of(keys["title"]);
    run.toolkit = string_of(keys["toolkit"]);
    run.seed = number_of<std::uint64_t>(keys["seed"], 0, most_seed);
    run.box = string_of(keys["box"]);
    run.feedback = enum_of(keys["feedback"], Feedback::full);
    run.date = string_of(keys["date"]);
    run.parts = number_of<unsigned>(keys["parts"], 1, most_parts);
    run.part = number_of<unsigned>(keys["part"], 1, run.parts);
    if (const Read& finished = keys["finished"]; !finished.is_null()) {
      run.finished = list_of(finished, string_of);
      run.is_finished = true;
    }
    return run;
  });
}

}  // namespace fos::grading
