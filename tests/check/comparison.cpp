#include "comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fos/text.hpp"

namespace fos {
namespace {

constexpr int panel_size = 400;  // pixels, about

/// Each pixel `times` times in each direction, so that a circle round one can be drawn finely.
Bitmap magnified(Bitmap bitmap, int times) {
  if (times == 1) return bitmap;
  Bitmap large{bitmap.width * times, bitmap.height * times, {}};
  large.rgb.reserve(bitmap.rgb.size() * static_cast<std::size_t>(times) *
                    static_cast<std::size_t>(times));
  for (int row = 0; row < large.height; ++row) {
    for (int column = 0; column < large.width; ++column) {
      const int source = 3 * (row / times * bitmap.width + column / times);
      for (int i = 0; i < 3; ++i) {
        large.rgb.push_back(bitmap.rgb[static_cast<std::size_t>(source + i)]);
      }
    }
  }
  return large;
}

/// A black ring in a white one, so that it shows on any color.
void circle(Bitmap& bitmap, double x, double y, double radius, double width) {
  const double reach = radius + 2 * width;
  const auto from = [&](double center) { return std::max(0, static_cast<int>(center - reach)); };
  const auto to = [&](double center, int size) {
    return std::min(size, static_cast<int>(center + reach) + 1);
  };
  for (int row = from(y); row < to(y, bitmap.height); ++row) {
    for (int column = from(x); column < to(x, bitmap.width); ++column) {
      const double out = std::abs(std::hypot(column - x, row - y) - radius) / width;
      if (out > 1.5) continue;
      const auto first = static_cast<std::size_t>(3 * (row * bitmap.width + column));
      std::fill_n(bitmap.rgb.begin() + static_cast<std::ptrdiff_t>(first), 3,
                  static_cast<std::uint8_t>(out <= 0.75 ? 0 : 255));
    }
  }
}

}  // namespace

Difference difference(const Judge& judge, const Frame& frame) {
  const Frame& exact = judge.exact();
  Difference out;
  out.signed_channels.resize(frame.unwritten.size());
  bool finite = true;
  judge.each_wrong(frame, [&](Pixel pixel) {
    const auto yours = frame.pixel(pixel.column, pixel.row);
    const auto right = exact.pixel(pixel.column, pixel.row);
    long double most = 0;
    for (std::size_t i = 0; i < yours.size(); ++i) {
      const long double d = std::min(yours[i], 255.0L) - right[i];
      if (std::isfinite(most) && !(std::abs(d) <= std::abs(most))) most = d;
    }
    out.signed_channels[static_cast<std::size_t>(pixel.row * frame.header.width + pixel.column)] =
        static_cast<double>(most);
    const bool first_not_finite = finite && !std::isfinite(most);
    finite = finite && std::isfinite(most);
    if (first_not_finite || !out.worst || (finite && std::abs(most) > out.largest)) {
      out.worst = pixel;
    }
    if (std::isfinite(most))
      out.largest = std::max(out.largest, static_cast<double>(std::abs(most)));
  });
  return out;
}

Bitmap to_bitmap(const Difference& difference, int width, int height) {
  constexpr std::array<double, 3> more{230, 97, 1};
  constexpr std::array<double, 3> less{33, 102, 172};
  Bitmap bitmap{width, height, {}};
  bitmap.rgb.reserve(3 * difference.signed_channels.size());
  for (const double d : difference.signed_channels) {
    if (d == 0) {
      bitmap.rgb.insert(bitmap.rgb.end(), 3, 255);
      continue;
    }
    // A square root, so that small differences show beside large ones; what is wrong is never
    // white.
    const double share =
        std::isfinite(d) ? 0.2 + 0.8 * std::sqrt(std::abs(d) / difference.largest) : 1;
    const auto& full = d < 0 ? less : more;
    for (const double channel : full) bitmap.rgb.push_back(to_byte(255 + share * (channel - 255)));
  }
  return bitmap;
}

std::vector<Panel> compare(const Judge& judge, const Frame& frame, const Difference& differs) {
  const auto& [width, height, precision] = frame.header;
  std::vector<Panel> panels{
      {say(text::check_yours), to_bitmap(frame)},
      {say(text::check_right), to_bitmap(judge.exact())},
      {differs.worst ? say(text::check_difference, {fmt::format("{:.3g}", differs.largest)})
                     : say(text::check_no_difference),
       to_bitmap(differs, width, height)}};
  const int times = std::max(1, panel_size / std::max(width, height));
  for (Panel& panel : panels) {
    panel.bitmap = magnified(std::move(panel.bitmap), times);
    if (!differs.worst) continue;
    const double size = std::max(panel.bitmap.width, panel.bitmap.height);
    circle(panel.bitmap, times * (differs.worst->column + 0.5), times * (differs.worst->row + 0.5),
           size / 24, size / 200);
  }
  return panels;
}

}  // namespace fos
