// Where the labels of a plot's points go so that they cover neither each other nor the points.
#pragma once

#include <string>
#include <vector>

namespace fos::numerics {

/// A point in the plot's pixels, x to the right and y up, and how long its label is.
struct LabelledPoint {
  double x;
  double y;
  double label_width;
  bool on_line;  ///< a line joins it with the next such point, and labels keep off it
};

struct LabelPlace {
  double dx;      ///< from the point to the label's anchor
  double dy;      ///< to the label's middle
  int alignment;  ///< of the label at its anchor: -1 left, 0 centre, 1 right
};

/// For each point the first free place around it, the best of them where none is free. All labels
/// are `height` high and stay within 0..width and 0..plot_height.
std::vector<LabelPlace> place_labels(const std::vector<LabelledPoint>& points, double height,
                                     double width, double plot_height);

}  // namespace fos::numerics
