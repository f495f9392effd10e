#include "view_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "check_report.hpp"
#include "fos/text.hpp"
#include "json.hpp"

namespace fos {
namespace {

using Member = std::pair<std::string_view, std::string>;  // a name, and a value in JSON

std::string object(std::initializer_list<Member> members) {
  std::string out = "{";
  for (const auto& [name, value] : members) {
    if (out.size() > 1) out += ",\n";
    out += json_string(name) + ": " + value;
  }
  return out + "}";
}

std::string words(const Text& text) { return json_string(say(text)); }

/// A text whose placeholders the page fills in.
std::string pattern(const Text& text) { return json_string(say(text, {"{0}", "{1}"})); }

std::string texts() {
  return object({{"yours", words(text::watch_view_yours)},
                 {"expected", words(text::watch_view_expected)},
                 {"difference", words(text::watch_view_difference)},
                 {"passes", words(text::watch_view_passes)},
                 {"fails", words(text::watch_view_fails)},
                 {"no_build", words(text::watch_view_no_build)},
                 {"older", words(text::watch_view_older)},
                 {"no_frame", words(text::watch_view_no_frame)},
                 {"pixel", pattern(text::watch_view_pixel)},
                 {"right", words(text::watch_view_right)},
                 {"wrong", words(text::watch_view_wrong)},
                 {"bytes", words(text::watch_view_bytes)},
                 {"linear", words(text::watch_view_linear)},
                 {"explain", words(text::watch_view_explain)},
                 {"copy", words(text::watch_view_copy)},
                 {"copied", words(text::watch_view_copied)},
                 {"help", words(text::watch_view_help)}});
}

std::string list(const Findings& findings) {
  std::string out = "[";
  for (const Finding& finding : findings.list) {
    const char* mark = finding.outcome == Outcome::passed   ? "✓"
                       : finding.outcome == Outcome::failed ? "✗"
                                                            : "·";
    if (out.size() > 1) out += ",\n";
    out += object({{"mark", json_string(mark)}, {"words", json_string(finding.words)}});
  }
  return out + "]";
}

std::string first(const Findings& findings) {
  const Finding* failure = first_failure(findings);
  if (failure == nullptr) return json_string(findings.passes() ? findings.note : "");
  return json_string(failure->words + "\n" + failure->why);
}

std::string pictures(const View& view) {
  const Shown& shown = *view.findings->shown;
  const auto& [width, height, precision] = shown.frame->header;
  std::string urls;
  for (const std::string& png : view.pictures) {
    if (!urls.empty()) urls += ",\n";
    urls += "\"data:image/png;base64," + base64(png) + "\"";
  }
  std::string parts;
  for (const int part : view.parts) parts += (parts.empty() ? "" : ", ") + std::to_string(part);
  const Difference& differs = view.difference;
  const Pixel pixel = differs.worst ? shown.verdict.first_wrong() : Pixel{width / 2, height / 2};
  const std::string scene = view.scene_file.empty() ? "" : " --scene " + view.scene_file;
  return object(
      {{"width", std::to_string(width)},
       {"height", std::to_string(height)},
       {"urls", "[" + urls + "]"},
       {"scene", json_string(say(text::watch_view_scene, {shown.scene_name}))},
       {"difference", json_string(differs.worst ? say(text::check_difference,
                                                      {fmt::format("{:.3g}", differs.largest)})
                                                : say(text::check_no_difference))},
       {"column", std::to_string(pixel.column)},
       {"row", std::to_string(pixel.row)},
       {"rowsOfPart", std::to_string(rows_of_part(width))},
       {"parts", "[" + parts + "]"},
       {"explain",
        json_string(fmt::format("./lab explain {} {{0}} {{1}}{}", view.stage->id, scene))}});
}

void append(std::string& bytes, std::uint32_t number) {
  const std::array four{static_cast<char>(number), static_cast<char>(number >> 8U),
                        static_cast<char>(number >> 16U), static_cast<char>(number >> 24U)};
  bytes.append(four.data(), four.size());
}

}  // namespace

int rows_of_part(int width) {
  constexpr int most_pixels = 20'000;  // 28 bytes each, 37 in base64: 750 KB
  return std::max(1, most_pixels / std::max(1, width));
}

std::vector<ValuesPart> values_scripts(const Shown& shown, const std::string& id) {
  const Frame& exact = shown.judge->exact();
  const int width = shown.frame->header.width;
  if (shown.verdict.passes()) return {};
  std::vector<std::pair<int, std::string>> bytes;  // of each part
  shown.judge->each_wrong(*shown.frame, [&](Pixel pixel) {
    const int part = pixel.row / rows_of_part(width);
    if (bytes.empty() || bytes.back().first != part) bytes.emplace_back(part, "");
    append(bytes.back().second, static_cast<std::uint32_t>(pixel.row * width + pixel.column));
    for (const Frame* frame : {&*shown.frame, &exact}) {
      for (const long double channel : frame->pixel(pixel.column, pixel.row)) {
        append(bytes.back().second, std::bit_cast<std::uint32_t>(static_cast<float>(channel)));
      }
    }
  });
  std::vector<ValuesPart> parts;
  parts.reserve(bytes.size());
  for (const auto& [number, data] : bytes) {
    parts.push_back({number, "fosValues(" +
                                 object({{"id", json_string(id)},
                                         {"part", std::to_string(number)},
                                         {"data", "\"" + base64(data) + "\""}}) +
                                 ");\n"});
  }
  return parts;
}

std::string view_script(const View& view) {
  const Findings* findings = view.findings;
  const bool has_pictures = findings != nullptr && findings->shown && !view.pictures[0].empty();
  const char* outcome = findings == nullptr ? "no_build" : findings->passes() ? "passes" : "fails";
  return "fosView(" +
         object({{"id", json_string(view.id)},
                 {"stage", json_string(view.stage->id)},
                 {"name", words(view.stage->name)},
                 {"language", json_string(language() == Language::el ? "el" : "en")},
                 {"outcome", json_string(outcome)},
                 {"summary", json_string(findings == nullptr ? "" : summary(*findings))},
                 {"list", findings == nullptr ? "[]" : list(*findings)},
                 {"first", findings == nullptr ? json_string(view.compiler) : first(*findings)},
                 {"advice", json_string(view.advice)},
                 {"pictures", has_pictures ? pictures(view) : "null"},
                 {"texts", texts()}}) +
         ");\n";
}

std::string now_script(const std::string& id, const Stage& stage) {
  return "fosNow(" + json_string(id) + ", " + json_string(stage.id) + ");\n";
}

}  // namespace fos
