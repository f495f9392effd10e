#include "view_files.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "fos/text.hpp"
#include "fos/viewer_page.inc"  // generated: viewer_page, of viewer.html, viewer.css and viewer.js
#include "fos/whole_file.hpp"

namespace fos {
namespace {

/// A path in a URL: all but the plainest bytes as %XX.
std::string in_url(const std::string& path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  constexpr std::string_view plain =
      "/-_.~0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  std::string out;
  for (const char c : path) {
    if (plain.find(c) != std::string_view::npos) {
      out += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      out.append("%").append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
    }
  }
  return out;
}

/// Differs from that of every other check, also of another process.
std::string new_id() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::to_string(std::chrono::duration_cast<std::chrono::microseconds>(now).count()) + "-" +
         std::to_string(getpid());
}

}  // namespace

ViewFiles::ViewFiles(std::filesystem::path images) : images_(std::move(images)) {
  std::error_code error;
  std::filesystem::create_directories(images_, error);
  std::string page(viewer_page);
  constexpr std::string_view waiting = "@FOS_VIEWER_WAITING@";
  page.replace(page.find(waiting), waiting.size(), say(text::watch_view_waiting));
  write_whole_file(images_ / "viewer.html", page);
}

std::string ViewFiles::url() const {
  return "file://" + in_url(std::filesystem::absolute(images_ / "viewer.html").string());
}

std::filesystem::path ViewFiles::file(const Stage& stage, const std::string& rest) const {
  return images_ / (std::string(stage.id) + rest);
}

std::string ViewFiles::png(const Bitmap& bitmap, PictureMaker& maker) const {
  const std::filesystem::path path = images_ / (".view-" + std::to_string(getpid()) + ".png");
  if (!maker.make({path, {{"", bitmap}}, 0})) return "";
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::error_code error;
  std::filesystem::remove(path, error);
  return bytes;
}

std::filesystem::path ViewFiles::values_file(const Stage& stage, int part) const {
  return file(stage, "-view-" + std::to_string(part) + ".js");
}

void ViewFiles::remove_older_values(const View& view, int last) const {
  std::error_code error;
  for (int part = 0; part <= last; ++part) {
    if (std::find(view.parts.begin(), view.parts.end(), part) == view.parts.end()) {
      std::filesystem::remove(values_file(*view.stage, part), error);
    }
  }
}

std::string ViewFiles::write(View view, PictureMaker& maker) {
  view.id = new_id();
  std::string trouble;
  if (view.findings != nullptr && view.findings->shown) {
    const Shown& shown = *view.findings->shown;
    const auto& [width, height, precision] = shown.frame->header;
    if (view.difference.signed_channels.empty()) {  // it passes
      view.difference.signed_channels.resize(shown.frame->unwritten.size());
    }
    const std::array bitmaps{to_bitmap(*shown.frame), to_bitmap(shown.judge->exact()),
                             to_bitmap(view.difference, width, height)};
    for (std::size_t i = 0; i < bitmaps.size() && trouble.empty(); ++i) {
      view.pictures[i] = png(bitmaps[i], maker);
      if (view.pictures[i].empty()) trouble = maker.error();
    }
    if (!trouble.empty()) view.pictures = {};
    if (shown.scene_name != "lecture") {
      const auto path = file(*view.stage, "-view.scene");
      write_whole_file(path, shown.judge->scene().source);
      view.scene_file = "build/images/" + path.filename().string();
    }
    for (const ValuesPart& part : values_scripts(shown, view.id)) {
      view.parts.push_back(part.number);
      write_whole_file(values_file(*view.stage, part.number), part.script);
    }
    remove_older_values(view, height / rows_of_part(width));
  }
  write_whole_file(file(*view.stage, "-view.js"), view_script(view));
  write_whole_file(images_ / "view-now.js", now_script(view.id, *view.stage));
  return trouble;
}

}  // namespace fos
