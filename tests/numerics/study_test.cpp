// What is made of times and errors: statistics, rounds, the frontier, the table, CSV and plot.
#include "study.hpp"

#include <fmt/core.h>

#include <set>
#include <thread>

#include "catch2.hpp"
#include "fit.hpp"
#include "label_places.hpp"
#include "plot.hpp"
#include "table.hpp"

using namespace fos;
using namespace fos::numerics;

namespace {

Measured row(const char* id, double ratio, long double max, long wrong_bytes = 0) {
  Measured out;
  out.id = out.name = id;
  out.ns = {9 * ratio, 10 * ratio, 12 * ratio};
  out.ratio = ratio;
  out.errors.I = ErrorsOfI{max, max / 2, max / 4};
  out.errors.wrong_bytes = wrong_bytes;
  return out;
}

std::set<std::string> frontier(std::vector<Measured> rows) {
  mark_frontier(rows);
  std::set<std::string> out;
  for (const Measured& each : rows) {
    if (each.frontier) out.insert(each.id);
  }
  return out;
}

Study small_study() {
  Study study;
  study.rows = {row("float", 0.9, 3.25e-5L, 70), row("double", 1, 1.5e-13L), row("exact", 4, 0)};
  mark_frontier(study.rows);
  study.scene = "it's, \"mine\".scene";
  study.width = 600;
  study.height = 400;
  study.rounds = 15;
  study.processor = "P";
  study.compiler = "C";
  study.simd = "S";
  return study;
}

std::size_t columns(std::string_view line) {
  return static_cast<std::size_t>(std::count_if(
      line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == '\n') {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

}  // namespace

TEST_CASE("percentiles") {
  CHECK(median({3}) == 3);
  CHECK(median({5, 1, 3}) == 3);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  CHECK(percentile({0, 10}, 0.25) == 2.5);
  CHECK(percentile({1, 2, 3, 4, 5}, 0) == 1);
  CHECK(percentile({1, 2, 3, 4, 5}, 1) == 5);
  const Spread spread = spread_of({5, 1, 4, 2, 3});
  CHECK(spread.first_quartile == 2);
  CHECK(spread.median == 3);
  CHECK(spread.third_quartile == 4);
}

TEST_CASE("a ratio is taken inside each round") {
  // The machine is twice as slow from round to round; the ratio of the medians would be 1.5.
  CHECK(paired_ratio({3, 6, 12}, {2, 4, 8}) == 1.5);
  CHECK(paired_ratio({30, 1, 10}, {10, 10, 10}) == 1);
  CHECK(median({3, 60, 6}) / median({1, 20, 20}) != paired_ratio({3, 60, 6}, {1, 20, 20}));
  CHECK(paired_ratio({3, 60, 6}, {1, 20, 20}) == 3);
}

TEST_CASE("rounds: every rung once a round, each first in turn, tolls taken off") {
  std::string order;
  double elsewhere = 0;
  std::vector<Rung> rungs;
  for (const char* id : {"a", "b", "c"}) {
    rungs.push_back({id, id, [&order, id] { order += id; }, [](const Truth&) { return Errors(); }});
  }
  rungs[0].elsewhere = [&] { return elsewhere += 5e9; };  // 5 s more at every look
  rungs[1].elsewhere = [&] { return elsewhere += 2e9; };
  rungs[0].toll = 1;
  Pace pace;
  pace.rounds = 3;
  pace.shortest = std::chrono::milliseconds(0);
  std::vector<double> progress;
  const auto times = measure(rungs, 1000, pace, [&](double done) { progress.push_back(done); });
  // Twice each to begin with; then rounds.
  CHECK(order.substr(0, 6) == "aabbcc");
  CHECK(order.substr(6) == "abcbcacab");
  CHECK(times.size() == 3);
  CHECK(times[0].size() == 3);
  CHECK(progress.size() == 9);
  CHECK(progress.back() == 1);
  for (int round = 0; round < 3; ++round) {
    CHECK(times[0][static_cast<std::size_t>(round)] > 2e6);  // 3e9 ns over 1000 pixels, about
    CHECK(times[0][static_cast<std::size_t>(round)] < 4e6);
  }
  CHECK(times[1][0] > 1.9e6);
}

TEST_CASE("rounds end with the budget, but not before the least number of them") {
  const auto sleep = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  std::vector<Rung> rungs{{"a", "a", sleep, [](const Truth&) { return Errors(); }}};
  Pace pace;
  pace.rounds = 1000;
  pace.at_least = 4;
  pace.budget = std::chrono::milliseconds(1);
  pace.shortest = std::chrono::milliseconds(0);
  CHECK(measure(rungs, 1, pace, [](double) {})[0].size() == 4);
}

TEST_CASE("the frontier") {
  CHECK(frontier({row("a", 1, 1e-5L), row("b", 2, 1e-9L), row("c", 3, 1e-7L)}) ==
        std::set<std::string>{"a", "b"});
  // As exact and slower, or as fast and less exact, is beaten.
  CHECK(frontier({row("a", 1, 0), row("b", 2, 0)}) == std::set<std::string>{"a"});
  CHECK(frontier({row("a", 1, 1), row("b", 1, 2)}) == std::set<std::string>{"a"});
  CHECK(frontier({row("a", 1, 1), row("b", 1, 1)}) == std::set<std::string>{"a", "b"});
  // A NaN is no small error.
  std::vector<Measured> rows{row("a", 1, 1e-5L), row("b", 2, 1e-9L)};
  rows[1].errors.not_finite = 1;
  CHECK(frontier(rows) == std::set<std::string>{"a"});
  // Bytes only: beside the frontier.
  rows[1].errors = Errors();
  CHECK(frontier(rows) == std::set<std::string>{"a"});
}

TEST_CASE("the fastest row with right bytes") {
  std::vector<Measured> rows{row("a", 1, 1e-5L, 3), row("b", 2, 1e-9L), row("c", 3, 0)};
  mark_frontier(rows);
  CHECK_FALSE(rows[0].fastest_right);
  CHECK(rows[1].fastest_right);
  CHECK_FALSE(rows[2].fastest_right);
  rows[1].errors.open_bytes = 1;
  mark_frontier(rows);
  CHECK(rows[2].fastest_right);
}

TEST_CASE("the table has 80 columns, in both languages") {
  Study study = small_study();
  study.rows[2].errors.open_spheres = 12;
  study.rows[1].name = std::string(17, 'x');
  for (const char* language : {"en", "el"}) {
    setenv("FOS_LANG", language, 1);
    const std::string table = table_of(study);
    for (const std::string& line : lines(table)) {
      INFO(line);
      if (line.find("xxx") != std::string::npos) CHECK(columns(line) == 80);
      if (line.find("it's") == std::string::npos) CHECK(columns(line) <= 80);
    }
    CHECK_THAT(table, ContainsSubstring("3.2e-5"));
    CHECK_THAT(table, ContainsSubstring("1.5e-13"));
    CHECK_THAT(table, ContainsSubstring("12?"));
    CHECK_THAT(table, ContainsSubstring("*= xxxx"));
  }
  setenv("FOS_LANG", "en", 1);
  CHECK_FALSE(has(table_of(study), "smaller"));
  study.factor = 3;
  study.own_width = 1800;
  CHECK_THAT(table_of(study), ContainsSubstring("1800"));
  CHECK_THAT(table_of(study), ContainsSubstring("smaller 3 times"));
  CHECK_FALSE(has(table_of(study), "yours"));
  study.stage = "Point light";
  CHECK_THAT(table_of(study), ContainsSubstring("Point light"));
  CHECK_THAT(table_of(study), ContainsSubstring("yours"));
}

TEST_CASE("CSV: a header, as many fields in every line, quotes doubled, every digit") {
  Study study = small_study();
  study.rows[1].errors.I->max = 1 / 3.0L;
  study.rows[2].errors.I.reset();
  const std::string csv = csv_of(study);
  std::vector<int> fields;
  bool quoted = false;
  int count = 1;
  for (const char c : csv) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++count;
    if (c == '\n') fields.push_back(std::exchange(count, 1));
  }
  CHECK(fields == std::vector<int>(4, fields.front()));
  CHECK(csv.starts_with("rung,ns_per_pixel_median,"));
  CHECK_THAT(csv, ContainsSubstring("\"it's, \"\"mine\"\".scene\""));
  CHECK(std::stold(csv.substr(csv.find("0.33333"))) == 1 / 3.0L);
  CHECK_THAT(csv, ContainsSubstring("exact,40,36,48,4,,,,"));  // no I, no error of it
}

TEST_CASE("the plot's script") {
  setenv("FOS_LANG", "en", 1);
  const std::string script = plot_script(small_study(), PlotFormat::svg);
  CHECK_THAT(script, ContainsSubstring("set terminal svg"));
  CHECK_THAT(script, ContainsSubstring("it''s, \"mine\".scene'"));  // gnuplot's own quoting
  CHECK_THAT(script, ContainsSubstring("set label 'float' at"));
  CHECK_THAT(script, ContainsSubstring("'no error'"));
  CHECK(has(plot_script(small_study(), PlotFormat::png), "pngcairo"));
  Study study = small_study();
  study.rows.pop_back();
  CHECK_FALSE(has(plot_script(study, PlotFormat::png), "no error"));
  study.scene = "a\nplot 'x'";
  CHECK_FALSE(has(plot_script(study, PlotFormat::png), "\nplot 'x'"));
  CHECK(plot_format("a/b.SVG") == PlotFormat::svg);
  CHECK_THROWS_AS(plot_format("a.jpg"), std::invalid_argument);
}

TEST_CASE("labels of crowded points do not overlap") {
  const std::vector<LabelledPoint> points{
      {500, 300, 120, true}, {510, 300, 120, false}, {520, 300, 120, true}, {530, 300, 120, false}};
  const auto places = place_labels(points, 30, 1200, 700);
  struct Box {
    double left, right, middle;
  };
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double anchor = points[i].x + places[i].dx;
    const double left = places[i].alignment < 0   ? anchor
                        : places[i].alignment > 0 ? anchor - 120
                                                  : anchor - 60;
    boxes.push_back({left, left + 120, points[i].y + places[i].dy});
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = boxes[i].left >= boxes[j].right || boxes[j].left >= boxes[i].right ||
                         std::abs(boxes[i].middle - boxes[j].middle) >= 30;
      CHECK(apart);
    }
  }
  // At the right edge the label goes to the left.
  CHECK(place_labels({{1190, 300, 120, false}}, 30, 1200, 700)[0].alignment >= 0);
}

TEST_CASE("a canvas that fits into a minute") {
  SceneText scene;
  scene.canvas_width = 601;
  scene.canvas_height = 400;
  CHECK(made_smaller(scene, 1).canvas_width == 601);
  CHECK(made_smaller(scene, 4).canvas_width == 151);
  CHECK(made_smaller(scene, 4).canvas_height == 100);
  CHECK(made_smaller(scene, 16384).canvas_height == 1);
  CHECK(fit(scene, {1e-5, 1e-6}).factor == 1);
  const Fit slow = fit(scene, {1e-2, 1e-3});
  CHECK(slow.factor > 1);
  CHECK(slow.truth_seconds <= 20);
  CHECK(slow.round_seconds * rounds_aimed_at <= seconds_for_rounds);
  CHECK(fit(scene, {1e9, 1e9}).factor == 601);  // one pixel, whatever it takes
  scene.canvas_width = scene.canvas_height = 16384;
  CHECK(fit(scene, {0, 0}).factor == 17);
}
