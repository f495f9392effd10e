// The study as a picture: the largest error of I against the time, both logarithmic.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "study.hpp"

namespace fos::numerics {

enum class PlotFormat { png, svg };

/// By the file's extension, in any case; throws std::invalid_argument for another one.
PlotFormat plot_format(const std::filesystem::path& path);

/// What gnuplot is to draw, in the person's language. It draws to its standard output.
std::string plot_script(const Study& study, PlotFormat format);

/// What stands in the way of a plot, with the exit status.
class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Draws it with gnuplot into a file that is whole or not there. Throws PlotError and FileError.
void write_plot(const Study& study, const std::filesystem::path& path);

}  // namespace fos::numerics
