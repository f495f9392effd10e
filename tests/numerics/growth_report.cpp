// The measured growth as a table, as CSV and as a script for gnuplot.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "gnuplot.hpp"
#include "growth.hpp"

namespace fos::numerics {
namespace {

/// On the plot canvases are counted in ten thousands of pixels, beside spheres and lights.
double plotted(const GrowthSeries& series, const GrowthPoint& point) {
  return static_cast<double>(point.number) / (series.id == "canvas" ? 1e4 : 1);
}

}  // namespace

std::string table_of(const std::vector<GrowthSeries>& all) {
  std::string out = say(text::growth_title) + "\n";
  for (const GrowthSeries& series : all) {
    out += "\n" + say(*series.what) + "\n";
    out += fmt::format("{:>12}{:>12}{:>12}{:>9}{:>17}\n", say(*series.number),
                       say(text::growth_per_pixel), say(text::growth_frame),
                       say(text::growth_power), say(text::growth_setup));
    const GrowthPoint* before = nullptr;
    for (const GrowthPoint& point : series.points) {
      const std::string power =
          before == nullptr
              ? ""
              : fmt::format("{:.2f}", std::log(point.frame_ms / before->frame_ms) /
                                          std::log(static_cast<double>(point.number) /
                                                   static_cast<double>(before->number)));
      out +=
          fmt::format("{:>12}{:>12.3g}{:>12.3g}{:>9}{:>17.3g}\n", point.number,
                      1e6 * point.frame_ms / point.pixels, point.frame_ms, power, point.setup_ms);
      before = &point;
    }
  }
  return out + "\n" + say(text::growth_legend_power) + "\n" + say(text::growth_legend_setup) + "\n";
}

std::string csv_of(const std::vector<GrowthSeries>& all) {
  std::string out = "series,number,pixels,ns_per_pixel,frame_ms,setup_ms\r\n";
  for (const GrowthSeries& series : all) {
    for (const GrowthPoint& point : series.points) {
      out += fmt::format("{},{},{},{},{},{}\r\n", series.id, point.number, point.pixels,
                         1e6 * point.frame_ms / point.pixels, point.frame_ms, point.setup_ms);
    }
  }
  return out;
}

std::string growth_script(const std::vector<GrowthSeries>& all, bool as_png) {
  std::string out = fmt::format(
      "set encoding utf8\nset terminal {} size 1600,1000 font 'DejaVu Sans,22' background rgb "
      "'white'\n",
      as_png ? "pngcairo" : "svg");
  out += fmt::format("set title {} noenhanced font ',28'\nset xlabel {} noenhanced\n",
                     quoted(say(text::growth_plot_title)), quoted(say(text::growth_plot_x)));
  out += fmt::format("set ylabel {} noenhanced\n", quoted(say(text::growth_plot_y)));
  out +=
      "set logscale xy\nset format '%g'\nset border 3\nset xtics nomirror\nset ytics nomirror\n"
      "set grid xtics ytics linetype 1 linecolor rgb '#e4e4e4'\nset key left top\n"
      "unset mxtics\nunset mytics\n";
  std::string plots;
  const char* colors[] = {"#08519c", "#d95f0e", "#238b45"};
  double least_x = 1e300;
  double most_x = 0;
  double most_y = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    out += fmt::format("$s{} << END\n", i);
    for (const GrowthPoint& point : all[i].points) {
      const double x = plotted(all[i], point);
      least_x = std::min(least_x, x);
      most_x = std::max(most_x, x);
      most_y = std::max(most_y, point.frame_ms);
      out += fmt::format("{} {}\n", x, point.frame_ms);
    }
    out += "END\n";
    plots += fmt::format(
        ", $s{} with linespoints linewidth 4 pointtype 7 pointsize 2.2 linecolor rgb '{}' title {}",
        i, colors[i % 3], quoted(say(*all[i].number)));
  }
  out += fmt::format("set xrange [{}:{}]\n", least_x / 1.5, most_x * 1.5);
  out += fmt::format(
      "plot {} * x / {} with lines dashtype 2 linewidth 2 linecolor rgb '#808080' title {}", most_y,
      most_x, quoted(say(text::growth_plot_linear)));
  return out + plots + "\n";
}

}  // namespace fos::numerics
