// Pictures drawn by gnuplot.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fos::numerics {

enum class PlotFormat { png, svg };

/// By the file's extension, in any case; throws std::invalid_argument for another one.
PlotFormat plot_format(const std::filesystem::path& path);

/// Words for a script: in single quotes, where gnuplot takes every letter for itself.
std::string quoted(const std::string& words);

/// What stands in the way of a plot, with the exit status.
class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a script that draws to its standard output; the file is whole or not there. Throws
/// PlotError and FileError.
void draw(const std::string& script, const std::filesystem::path& path);

}  // namespace fos::numerics
