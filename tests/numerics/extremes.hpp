// The table of extremes: scenes of which one number is swept until something breaks, each asked at
// every precision of the slides' formulas, as they stand, and of the solution of `combined`.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fos/frame.hpp"
#include "fos/scene_text.hpp"
#include "fos/text.hpp"

namespace fos::numerics {

inline constexpr std::array all_precisions{Precision::binary32, Precision::binary64,
                                           Precision::extended};
std::string_view name_of(Precision precision);  ///< float, double, long double

/// Half the step from one byte to the next, for a color of 255: what may show in a picture.
inline constexpr double half_a_byte = 1.0 / 510;

/// How an answer differs from the truth, over all pixels.
struct Errors {
  long pixels = 0;
  double max = 0;          ///< of |ΔI| / max(1, I), where the sphere is right and I finite
  double mean = 0;         ///< over the same pixels
  long wrong_bytes = 0;    ///< of 255 I, or of a wrong sphere, or not finite
  long wrong_spheres = 0;  ///< and no boundary case
  long boundary = 0;       ///< another sphere, which is right a thousandth of a pixel away
  long not_finite = 0;     ///< I or 255 I is NaN or infinite

  bool breaks() const { return max > half_a_byte || wrong_spheres > 0 || not_finite > 0; }
};

/// One way of asking, at one precision and value of the parameter.
struct Answered {
  Errors errors;
  std::string refusal;  ///< why there is no answer; else empty
  double ns = 0;        ///< per item, where a family measures time
};

/// One line of a table: its ways are answered in the order of the family's names for them.
struct Line {
  std::string parameter;
  Precision precision = Precision::binary64;
  std::vector<Answered> ways;
};

/// What is asked, and what is right about it: where `truth` is empty, the same scene.
struct Case {
  std::string parameter;
  std::string scene;
  std::string truth;
};

struct Family {
  std::string_view id;
  Text title;    ///< what is swept
  Text finding;  ///< what breaks, the remedy and its cost
  std::vector<std::string_view> ways;
  std::vector<std::string> parameters;  ///< in the order of the sweep
  /// The lines of one parameter, one a precision.
  std::function<std::vector<Line>(std::size_t parameter)> ask;
};

/// All families, in the order of the table.
std::vector<Family> families();

/// The families that are scenes, asked of the slides' formulas and of the solution.
Family scene_family(std::string_view id, Text title, Text finding, std::vector<Case> cases);

/// The lines of one family as a table of 80 columns, with a summary below.
std::string table_of(const Family& family, const std::vector<Line>& lines);

/// What the columns mean, to stand below the tables.
std::string legend();

/// The same for other programs: a line a way, with a header line.
std::string csv_header();
std::string csv_of(const Family& family, const std::vector<Line>& lines);

}  // namespace fos::numerics
