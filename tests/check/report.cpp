#include "report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fos/bitmap.hpp"
#include "fos/text.hpp"

namespace fos {
namespace {

std::string line(const Text& text, std::string_view scene, const Count& count, const Frame& frame) {
  return say(text, {scene, std::to_string(count.pixels), std::to_string(frame.unwritten.size()),
                    std::to_string(count.first.column), std::to_string(count.first.row)}) +
         "\n";
}

std::string in_words(const Expected& expected) {
  std::string channels = "(";
  for (const Interval& channel : expected.channels) {
    if (channels.size() > 1) channels += ", ";
    const std::string low = fmt::format("{:.10g}", channel.low);
    const std::string high = fmt::format("{:.10g}", channel.high);
    channels += low == high ? low : fmt::format("{} .. {}", low, high);
  }
  const auto& [r, g, b] = expected.bytes;
  const std::string what = expected.sphere == 0
                               ? say(text::check_background)
                               : say(text::check_sphere, {std::to_string(expected.sphere)});
  return say(text::check_expected, {channels + ")", fmt::format("{} {} {}", r, g, b), what}) + "\n";
}

/// The pixel as it came, and beside it every right answer.
std::string pixel_in_words(const Judge& judge, const Frame& frame, Pixel pixel) {
  const auto channels = frame.pixel(pixel.column, pixel.row);
  const auto precision = frame.header.precision == Precision::binary32
                             ? reference::Precision::float24
                             : reference::Precision::double53;
  std::string out;
  for (const Expected& expected : judge.expected(pixel, precision)) out += in_words(expected);
  const std::string bytes = is_finite(channels)
                                ? fmt::format("{} {} {}", to_byte(channels[0]),
                                              to_byte(channels[1]), to_byte(channels[2]))
                                : "-";
  return out +
         say(text::check_came,
             {fmt::format("({:.10g}, {:.10g}, {:.10g})", channels[0], channels[1], channels[2]),
              bytes}) +
         "\n";
}

/// White where both agree, toward orange where yours is more, toward blue where it is less; the
/// largest difference has the full color.
Bitmap difference(const Frame& yours, const Frame& expected) {
  std::vector<double> more(yours.unwritten.size());
  double largest = 1e-3;  // below that, a thousandth of a byte's step, it stays pale
  for (std::size_t i = 0; i < more.size(); ++i) {
    for (std::size_t channel = 3 * i; channel < 3 * i + 3; ++channel) {
      const long double d = yours.channels[channel] - expected.channels[channel];
      if (!(std::abs(d) <= std::abs(more[i]))) more[i] = static_cast<double>(d);
    }
    if (std::isfinite(more[i])) largest = std::max(largest, std::abs(more[i]));
  }
  Bitmap bitmap{yours.header.width, yours.header.height, {}};
  for (const double d : more) {
    const std::array<double, 3> full =
        d > 0 ? std::array<double, 3>{230, 97, 1} : std::array<double, 3>{33, 102, 172};
    const double share = std::isfinite(d) ? std::sqrt(std::abs(d) / largest) : 1;
    for (const double channel : full) bitmap.rgb.push_back(to_byte(255 + share * (channel - 255)));
  }
  return bitmap;
}

}  // namespace

std::string describe(const Judge& judge, const Frame& frame, const Verdict& verdict,
                     std::string_view scene_name) {
  std::string out;
  const auto finding = [&](const Text& text, const Count& count) {
    if (count.pixels > 0) out += line(text, scene_name, count, frame);
  };
  finding(text::check_not_finite, verdict.not_finite);
  finding(text::check_unwritten, verdict.unwritten);
  finding(text::check_wrong, verdict.wrong);
  const Count* shown = verdict.not_finite.pixels > 0 ? &verdict.not_finite
                       : verdict.wrong.pixels > 0    ? &verdict.wrong
                                                     : nullptr;
  if (shown != nullptr) out += pixel_in_words(judge, frame, shown->first);
  if (verdict.passes()) finding(text::check_only_float, verdict.only_float);
  finding(text::check_not_judged, verdict.not_judged);
  return out;
}

std::string describe(const Answer& answer, std::string_view scene_name) {
  const std::string detail = std::to_string(answer.detail);
  const std::string rows = std::to_string(answer.rows);
  switch (answer.ending) {
    case Ending::complete:
      return "";
    case Ending::refused:
      return say(text::check_refused, {scene_name});
    case Ending::crashed:
      return say(text::check_crashed, {scene_name, strsignal(answer.detail), rows});
    case Ending::timed_out:
      return say(text::check_timed_out, {scene_name, rows});
    case Ending::exited:
      return say(text::check_exited, {scene_name, detail, rows});
    case Ending::malformed:
      return say(text::check_malformed, {scene_name});
    case Ending::did_not_start:
      break;
  }
  return say(text::check_did_not_start, {scene_name, std::strerror(answer.detail)});
}

bool write_comparison(const std::filesystem::path& picture_program,
                      const std::filesystem::path& path, const Judge& judge, const Frame& frame) {
  const Frame exact = judge.exact();
  // The shell gets the paths as variables, so that no character in them means anything to it.
  setenv("FOS_SHEET_PROGRAM", picture_program.c_str(), 1);
  setenv("FOS_SHEET_PATH", path.c_str(), 1);
  // A picture program that is not there must not take the report with it.
  std::signal(SIGPIPE, SIG_IGN);
  std::FILE* sheet = popen(R"("$FOS_SHEET_PROGRAM" sheet 3 400 "$FOS_SHEET_PATH")", "w");
  if (sheet == nullptr) return false;
  for (const Panel& panel : {Panel{say(text::check_yours), to_bitmap(frame)},
                             Panel{say(text::check_right), to_bitmap(exact)},
                             Panel{say(text::check_difference), difference(frame, exact)}}) {
    const std::string bytes = encode(panel);
    std::fwrite(bytes.data(), 1, bytes.size(), sheet);
  }
  return pclose(sheet) == 0;
}

}  // namespace fos
