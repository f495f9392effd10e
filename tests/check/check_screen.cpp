#include "check_screen.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "preview.hpp"

namespace fos {
namespace {

std::string explain_line(const Stage& stage, const Spot& spot,
                         const std::filesystem::path& images) {
  std::string scene;
  if (!spot.scene_text.empty()) {
    const auto path = images / (std::string(stage.id) + "-check.scene");
    write_whole_file(path, spot.scene_text);
    scene = " --scene " + quoted(path);
  }
  return say(text::check_explain) + "\n" +
         fmt::format("  ./lab explain {} {} {}{}\n", stage.id, spot.pixel.column, spot.pixel.row,
                     scene);
}

std::string preview_of(const Findings& findings, const std::vector<Panel>& panels,
                       const Paint& paint, const Window& window) {
  constexpr int widest = 24;  // characters a panel: three of them in 80 columns
  constexpr int narrowest = 8;
  const int columns = std::min(widest, (window.columns - 6) / 3);
  if (columns < narrowest || !findings.shown) return "";
  return "\n" + preview(panels.empty() ? std::vector<Panel>{{say(text::check_yours),
                                                             to_bitmap(*findings.shown->frame)}}
                                       : panels,
                        columns, paint.colors());
}

long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace

std::string quoted(const std::filesystem::path& path) {
  const std::filesystem::path from_here = path.lexically_proximate(std::filesystem::current_path());
  const bool below = !from_here.empty() && *from_here.begin() != "..";
  const std::string word = (below ? from_here : path).string();
  return word.find(' ') == std::string::npos ? word : "'" + word + "'";
}

std::filesystem::path picture_path(const Stage& stage, const std::filesystem::path& images) {
  return images / (std::string(stage.id) + "-check.png");
}

std::string picture_line(const std::filesystem::path& path) {
  return say(text::check_picture, {quoted(path)}) + "\n";
}

Difference difference_of(const Findings& findings) {
  if (!findings.shown || findings.shown->verdict.passes()) return {};
  return difference(*findings.shown->judge, *findings.shown->frame);
}

std::vector<Panel> panels_of(const Findings& findings, const Difference& differs) {
  if (!findings.shown || findings.shown->verdict.passes()) return {};
  return compare(*findings.shown->judge, *findings.shown->frame, differs);
}

std::string check_screen(const Findings& findings, const std::string& advice,
                         const std::vector<Panel>& panels, const std::filesystem::path& images,
                         const Paint& paint, const Window& window) {
  const std::string report = describe(findings, paint);
  std::string after = advice.empty() ? "" : "\n" + advice;
  after += "\n" + next_step(findings);
  if (const Finding* first = first_failure(findings); first != nullptr && first->spot) {
    after += explain_line(*findings.stage, *first->spot, images);
  }
  std::string pictures;
  if (window.preview) pictures = preview_of(findings, panels, paint, window);
  const long all = lines(report) + lines(pictures) + lines(after);
  if (window.rows > 0 && all > window.rows) pictures.clear();
  return report + pictures + after;
}

std::string check_screen(const Stage& stage, const std::string& compiler, const Paint& paint) {
  std::string out = paint.bold(stage.id) + " · " + say(stage.name) + "\n  " + paint.red("✗") + " " +
                    say(text::check_does_not_build) + "\n";
  if (!compiler.empty()) out += "\n" + compiler;
  return out;
}

}  // namespace fos
