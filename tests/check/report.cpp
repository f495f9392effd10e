#include "report.hpp"

#include <fmt/core.h>

#include <cmath>
#include <csignal>
#include <cstring>

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
  return say(text::check_expected, {channels + ")", fmt::format("{} {} {}  ({})", r, g, b, what)}) +
         "\n";
}

std::string number(long double channel) {
  return std::isnan(channel) ? "NaN" : fmt::format("{:.10g}", channel);
}

/// What came at a pixel.
std::string in_words(std::span<const long double, 3> channels, bool unwritten) {
  if (unwritten) return say(text::check_pixel_unwritten) + "\n";
  const std::string bytes = is_finite(channels)
                                ? fmt::format("{} {} {}", to_byte(channels[0]),
                                              to_byte(channels[1]), to_byte(channels[2]))
                                : "-";
  return say(text::check_came, {fmt::format("({}, {}, {})", number(channels[0]),
                                            number(channels[1]), number(channels[2])),
                                bytes}) +
         "\n";
}

/// The pixel as it came, and beside it every right answer.
std::string pixel_in_words(const Judge& judge, const Frame& frame, Pixel pixel) {
  const auto precision = frame.header.precision == Precision::binary32
                             ? reference::Precision::float24
                             : reference::Precision::double53;
  std::string out;
  for (const Expected& expected : judge.expected(pixel, precision)) out += in_words(expected);
  return out + in_words(frame.pixel(pixel.column, pixel.row),
                        frame.is_unwritten(pixel.column, pixel.row));
}

/// What a signal means to one who wrote a few lines of C++.
std::string crash(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return say(text::check_crash_segv);
    case SIGFPE:
      return say(text::check_crash_fpe);
    case SIGABRT:
      return say(text::check_crash_abort);
    default:
      return strsignal(signal);
  }
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
  if (!verdict.passes()) out += pixel_in_words(judge, frame, verdict.first_wrong());
  if (verdict.passes()) finding(text::check_only_float, verdict.only_float);
  finding(text::check_not_judged, verdict.not_judged);
  return out;
}

std::string describe(const PixelCase& expected, const Frame& frame) {
  const auto [column, row] = expected.pixel;
  const auto came = frame.pixel(column, row);
  const auto& [r, g, b] = expected.expected;
  const std::string bytes = fmt::format("{} {} {}", to_byte(r), to_byte(g), to_byte(b));
  const std::string scene =
      expected.scene.empty() ? say(text::check_the_lecture) : say(text::check_this_scene);
  return say(text::check_pixel_at, {scene, std::to_string(column), std::to_string(row)}) + "\n" +
         say(text::check_expected, {fmt::format("({:.10g}, {:.10g}, {:.10g})", r, g, b), bytes}) +
         "\n" + in_words(came, frame.is_unwritten(column, row));
}

std::string describe(const Answer& answer, std::string_view scene_name) {
  const std::string detail = std::to_string(answer.detail);
  const std::string row = std::to_string(answer.rows);
  const std::string column = std::to_string(answer.pixels);
  switch (answer.ending) {
    case Ending::complete:
      return "";
    case Ending::refused:
      return say(text::check_refused, {scene_name}) + "\n";
    case Ending::crashed:
      return say(text::check_crashed, {scene_name, crash(answer.detail), column, row}) + "\n";
    case Ending::timed_out:
      return say(text::check_timed_out, {scene_name, column, row}) + "\n";
    case Ending::out_of_memory:
      return say(text::check_out_of_memory, {scene_name, column, row}) + "\n";
    case Ending::exited:
      return say(text::check_exited, {scene_name, detail, column, row}) + "\n";
    case Ending::malformed:
      return say(text::check_malformed, {scene_name}) + "\n";
    case Ending::did_not_start:
      break;
  }
  return say(text::check_did_not_start, {scene_name, std::strerror(answer.detail)}) + "\n";
}

}  // namespace fos
