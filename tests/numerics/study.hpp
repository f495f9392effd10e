// The finished study: what was measured, ready to be shown.
#pragma once

#include <string>
#include <vector>

#include "rounds.hpp"
#include "rung.hpp"

namespace fos::numerics {

/// One row of the table.
struct Measured {
  std::string id;
  std::string name;
  Spread ns;         ///< nanoseconds a pixel
  double ratio = 1;  ///< times the slides' formula in double, by paired_ratio
  Errors errors;
  bool frontier = false;       ///< no other row is both as fast and as exact
  bool fastest_right = false;  ///< no faster row has every byte right
};

struct Study {
  std::vector<Measured> rows;
  std::string scene;
  std::string stage;  ///< whose light all rungs compute, in words; empty for all of the scene's
  int width = 0;      ///< of the canvas measured
  int height = 0;
  int own_width = 0;  ///< of the scene's own canvas
  int own_height = 0;
  int factor = 1;  ///< so many times as large as the one measured
  int rounds = 0;
  std::string processor;
  std::string compiler;
  std::string simd;                ///< the target that the SIMD rungs ran on
  std::vector<std::string> notes;  ///< what was left out, in words
};

/// The rungs' rows without those that are only a toll, frontier marked.
std::vector<Measured> rows_of(const std::vector<Rung>& rungs, const std::vector<Times>& times,
                              const Truth& truth);

/// Marks the frontier of time and largest error of I among the rows that have an I, and the fastest
/// row with every byte right. A pixel that is not finite is an infinite error.
void mark_frontier(std::vector<Measured>& rows);

}  // namespace fos::numerics
