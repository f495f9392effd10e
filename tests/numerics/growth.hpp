// How the time of a certified picture grows with what there is to see.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fos/text.hpp"

namespace fos::numerics {

struct GrowthPoint {
  long number = 0;  ///< of spheres, of lights, of pixels
  double pixels = 0;
  double frame_ms = 0;  ///< processor time of a frame
  double setup_ms = 0;  ///< of a Renderer, exact arithmetic included
};

struct GrowthSeries {
  std::string id;      ///< in CSV
  const Text* number;  ///< what is counted
  const Text* what;
  std::vector<GrowthPoint> points;
};

/// All three series; `on_progress` hears the share that is done.
std::vector<GrowthSeries> measure_growth(const std::function<void(double done)>& on_progress);

/// The scene of `count` spheres in view, which together look equally large whatever their number.
std::string spheres_in_view(int count);
/// The lecture's spheres under `count` lights, every other one directional.
std::string under_lights(int count);

std::string table_of(const std::vector<GrowthSeries>& all);
std::string csv_of(const std::vector<GrowthSeries>& all);
/// For gnuplot: all series, log-log, beside a line of slope 1.
std::string growth_script(const std::vector<GrowthSeries>& all, bool as_png);

}  // namespace fos::numerics
