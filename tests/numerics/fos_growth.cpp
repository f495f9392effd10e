// fos_growth: how the time of a certified picture grows. `./lab trade --growth` calls it.
//   fos_growth [--csv F] [--plot F]
#include <getopt.h>

#include <iostream>

#include "fos/progress.hpp"
#include "fos/whole_file.hpp"
#include "gnuplot.hpp"
#include "growth.hpp"

namespace {

using namespace fos;
using namespace fos::numerics;

int failed(int status, const std::string& message) {
  std::cerr << say(text::tool_error) << ": " << message << '\n';
  return status;
}

int growth(int argc, char** argv) {
  std::filesystem::path csv;
  std::filesystem::path plot;
  const option known[] = {
      {"csv", required_argument, nullptr, 'c'}, {"plot", required_argument, nullptr, 'p'}, {}};
  for (int which = 0; (which = getopt_long(argc, argv, "", known, nullptr)) != -1;) {
    if (which != 'c' && which != 'p') return failed(2, say(text::tool_usage));
    (which == 'c' ? csv : plot) = optarg;
  }
  if (optind != argc) return failed(2, say(text::tool_usage));
  // Before minutes are spent: whether the files can be made at all.
  const PlotFormat format = plot.empty() ? PlotFormat::png : plot_format(plot);
  for (const std::filesystem::path& path : {csv, plot}) {
    if (!path.empty()) const WholeFile trial(path);
  }
  std::vector<GrowthSeries> series;
  {
    Progress progress(say(text::trade_progress_rounds), 1000);
    series = measure_growth([&](double done) { progress.update(static_cast<long>(1000 * done)); });
  }
  std::cout << table_of(series) << std::flush;
  if (!csv.empty()) write_whole_file(csv, csv_of(series));
  if (!plot.empty()) draw(growth_script(series, format == PlotFormat::png), plot);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return growth(argc, argv);
  } catch (const std::invalid_argument& error) {  // a plot of no known format
    return failed(2, error.what());
  } catch (const FileError& error) {
    return failed(error.exit_status, error.what());
  } catch (const std::exception& error) {
    return failed(3, error.what());
  }
}
