#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fos/text.hpp"
#include "label_places.hpp"
#include "plot.hpp"

namespace fos::numerics {
namespace {

// Pixels. The letters are large enough for the last row of a lecture hall.
constexpr double width = 1600, height = 1000;
constexpr double left = 200, right = 40, bottom = 115, top = 130;
constexpr double letter_width = 14.5, letter_height = 32;

struct Axes {
  double min_x, max_x, min_y, max_y;  // powers of ten
  double zero;                        // where what has no error sits

  double to_pixel_x(double x) const {
    return (std::log10(x) - min_x) / (max_x - min_x) * (width - left - right);
  }
  double to_pixel_y(double y) const {
    return (std::log10(y) - min_y) / (max_y - min_y) * (height - bottom - top);
  }
};

struct Point {
  const Measured* row;
  double x;  // ns a pixel
  double y;  // error, > 0
};

std::size_t letters(const std::string& utf8) {
  return static_cast<std::size_t>(std::count_if(
      utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

bool has_right_bytes(const Measured& row) {
  return row.errors.wrong_bytes + row.errors.open_bytes + row.errors.not_finite == 0;
}

/// Bytes and no I: they are proven, not measured.
bool is_proven(const Measured& row) { return !row.errors.I; }

std::string label_of(const Measured& row) {
  return is_proven(row) ? say(text::trade_plot_certified) : row.name;
}

/// The points, by the ratios: they are steadier than the times.
std::vector<Point> points_of(const Study& study) {
  double base = 1;
  for (const Measured& row : study.rows) {
    if (row.id == baseline_id) base = row.ns.median;
  }
  std::vector<Point> points;
  for (const Measured& row : study.rows) {
    // What gives bytes only has its place where they are all right: on the line of no error.
    if (!row.errors.I && !has_right_bytes(row)) continue;
    const long double error = row.errors.I ? row.errors.I->max : 0;
    points.push_back({&row, row.ratio * base, static_cast<double>(error)});
  }
  return points;
}

Axes axes_of(std::vector<Point>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double min_x = infinity, max_x = 0, min_y = infinity, max_y = 0;
  for (const Point& point : points) {
    min_x = std::min(min_x, point.x), max_x = std::max(max_x, point.x);
    if (point.y > 0) min_y = std::min(min_y, point.y), max_y = std::max(max_y, point.y);
  }
  if (max_y == 0) min_y = max_y = 1e-16;  // nobody has an error
  const bool has_zero =
      std::any_of(points.begin(), points.end(), [](const Point& point) { return point.y == 0; });
  const double lowest = std::floor(std::log10(min_y));
  const double zero = lowest - 2;
  for (Point& point : points) {
    if (point.y == 0) point.y = std::pow(10, zero);
  }
  return {std::log10(min_x) - 0.15, std::log10(max_x) + 0.4, has_zero ? zero - 0.7 : lowest - 0.7,
          std::ceil(std::log10(max_y)) + 0.7, std::pow(10, zero)};
}

/// 1, 2, 5, 10, 20 … along the time.
std::string ticks(const Axes& axes) {
  std::string out;
  for (int power = static_cast<int>(std::floor(axes.min_x)); power <= axes.max_x; ++power) {
    for (const double step : {1, 2, 5}) {
      const double x = step * std::pow(10, power);
      if (std::log10(x) < axes.min_x || std::log10(x) > axes.max_x) continue;
      out += fmt::format("{}'{:g}' {:g}", out.empty() ? "set xtics (" : ", ", x, x);
    }
  }
  return out.empty() ? out : out + ")\n";
}

std::string data(const char* name, const std::vector<Point>& points,
                 const std::function<bool(const Measured&)>& wanted) {
  std::string out = fmt::format("${} << END\n", name);
  for (const Point& point : points) {
    if (wanted(*point.row)) out += fmt::format("{} {}\n", point.x, point.y);
  }
  return out + "END\n";
}

std::string labels(const std::vector<Point>& points, const Axes& axes) {
  std::vector<LabelledPoint> labelled;
  labelled.reserve(points.size());
  for (const Point& point : points) {
    labelled.push_back({axes.to_pixel_x(point.x), axes.to_pixel_y(point.y),
                        letter_width * static_cast<double>(letters(label_of(*point.row))),
                        point.row->frontier});
  }
  const std::vector<LabelPlace> places =
      place_labels(labelled, letter_height, width - left - right, height - bottom - top);
  const std::map<int, const char*> alignment{{-1, "left"}, {0, "center"}, {1, "right"}};
  std::string out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    out += fmt::format(
        "set label {} at graph {:.5f},{:.5f} {} front noenhanced textcolor rgb '{}'\n",
        quoted(label_of(*points[i].row)), (labelled[i].x + places[i].dx) / (width - left - right),
        (labelled[i].y + places[i].dy) / (height - bottom - top), alignment.at(places[i].alignment),
        points[i].row->frontier || is_proven(*points[i].row) ? "#000000" : "#707070");
  }
  return out;
}

}  // namespace

std::string plot_script(const Study& study, PlotFormat format) {
  std::vector<Point> points = points_of(study);
  const Axes axes = axes_of(points);
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const bool zero = std::any_of(points.begin(), points.end(),
                                [&](const Point& point) { return point.y == axes.zero; });
  const auto is_yours = [](const Measured& row) { return row.id.starts_with("yours"); };

  std::string out = "set encoding utf8\n";
  out += fmt::format("set terminal {} size {},{} font 'DejaVu Sans,22' background rgb 'white'\n",
                     format == PlotFormat::png ? "pngcairo" : "svg", width, height);
  out += fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
      "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n",
      left / width, 1 - right / width, bottom / height, 1 - top / height);
  out += fmt::format("set title {} noenhanced font ',28' offset 0,1.2\n",
                     quoted(say(text::trade_plot_title, {study.scene})));
  out += fmt::format("set xlabel {} noenhanced\nset ylabel {} noenhanced offset -1,0\n",
                     quoted(say(text::trade_plot_time)), quoted(say(text::trade_plot_error)));
  out += fmt::format("set logscale xy\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
                     std::pow(10, axes.min_x), std::pow(10, axes.max_x), std::pow(10, axes.min_y),
                     std::pow(10, axes.max_y));
  out += "set ytics format '10^{%L}'\nset border 3\nset xtics nomirror\nset ytics nomirror\n";
  out += "set grid xtics ytics linetype 1 linecolor rgb '#e4e4e4'\n";
  out += "unset mytics\nset key at graph 1,1.015 right bottom\n";
  out += ticks(axes);
  if (zero) {
    out += fmt::format("set ytics add ({} {})\n", quoted(say(text::trade_plot_zero)), axes.zero);
    out += fmt::format(
        "set arrow from graph 0, first {0} to graph 1, first {0} nohead linecolor rgb '#d0d0d0' "
        "dashtype 2 linewidth 2\n",
        axes.zero);
  }
  out += labels(points, axes);
  out += data("frontier", points, [](const Measured& row) { return row.frontier; });
  const auto is_other = [&](const Measured& row) {
    return !row.frontier && !is_yours(row) && !is_proven(row);
  };
  out += data("others", points, is_other);
  out += data("proven", points, is_proven);
  out += data("yours", points, is_yours);
  out += fmt::format("plot $frontier with lines linewidth 4 linecolor rgb '#9ecae1' title {}",
                     quoted(say(text::trade_plot_frontier)));
  // An empty block is an error to gnuplot.
  const auto has = [&](const std::function<bool(const Measured&)>& wanted) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Point& point) { return wanted(*point.row); });
  };
  if (has(is_other)) {
    out += ", $others with points pointtype 7 pointsize 2.2 linecolor rgb '#a0a0a0' notitle";
  }
  out += ", $frontier with points pointtype 7 pointsize 2.6 linecolor rgb '#08519c' notitle";
  if (has(is_yours)) {
    out += ", $yours with points pointtype 5 pointsize 2.6 linecolor rgb '#d95f0e' notitle";
  }
  if (has(is_proven)) {
    out += ", $proven with points pointtype 13 pointsize 3.2 linecolor rgb '#238b45' notitle";
  }
  return out + "\n";
}

}  // namespace fos::numerics
