#include "histogram.hpp"

#include <algorithm>
#include <string>

#include "fos/text.hpp"

namespace fos::grading {
namespace {

constexpr long width = 600, base = 190, top = 25, step = width / 10, gap = 4;

void add_label(MarkupWriter& out, long x, long y, std::string_view words) {
  out.raw(R"(<text text-anchor="middle")").attribute("x", x).attribute("y", y);
  out.raw(">").text(words).raw("</text>");
}

}  // namespace

void add_histogram(MarkupWriter& out, const std::array<int, 10>& tenths) {
  std::string words = say(text::report_histogram) + ".";
  const long tallest = std::max(1, *std::max_element(tenths.begin(), tenths.end()));
  MarkupWriter bars;
  for (long i = 0; i < 10; ++i) {
    const long count = tenths[static_cast<std::size_t>(i)];
    const std::string bar =
        say(text::report_histogram_bar,
            {std::to_string(i * 10), std::to_string(i * 10 + 10), std::to_string(count)});
    words += " " + bar + ".";
    if (count == 0) continue;
    // A pixel at least: one of a thousand is not none.
    const long height = std::max(2L, count * (base - top) / tallest);
    bars.raw(R"(<rect class="bar" rx="2")").attribute("x", i * step + gap);
    bars.attribute("y", base - height).attribute("width", step - 2 * gap);
    bars.attribute("height", height).raw(">").element("title", bar).raw("</rect>");
    add_label(bars, i * step + step / 2, base - height - 6, std::to_string(count));
  }
  for (long i = 0; i <= 10; i += 2) {
    add_label(bars, std::clamp(i * step, 22L, width - 22), base + 22, std::to_string(i * 10));
  }
  add_label(bars, width / 2, base + 47, say(text::report_percent));
  out.raw(R"(<svg viewBox="0 0 600 240" role="img")").attribute("aria-label", words);
  out.raw(R"(><line class="axis" x1="0" x2="600")").attribute("y1", base);
  out.attribute("y2", base).raw("/>").add(bars).raw("</svg>\n");
}

}  // namespace fos::grading
