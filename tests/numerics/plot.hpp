// The study as a picture: the largest error of I against the time, both logarithmic.
#pragma once

#include <string>

#include "gnuplot.hpp"
#include "study.hpp"

namespace fos::numerics {

/// What gnuplot is to draw, in the person's language. It draws to its standard output.
std::string plot_script(const Study& study, PlotFormat format);

}  // namespace fos::numerics
