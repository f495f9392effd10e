#include "label_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fos::numerics {
namespace {

struct Box {
  double left, bottom, right, top;
};

double overlap(const Box& a, const Box& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
  return width > 0 && height > 0 ? width * height : 0;
}

Box box_of(const LabelledPoint& point, const LabelPlace& place, double height) {
  const double anchor = point.x + place.dx;
  const double left = place.alignment < 0   ? anchor
                      : place.alignment > 0 ? anchor - point.label_width
                                            : anchor - point.label_width / 2;
  const double middle = point.y + place.dy;
  return {left, middle - height / 2, left + point.label_width, middle + height / 2};
}

/// Small boxes all along the line that joins the points on it.
void take_line(const std::vector<LabelledPoint>& points, double step, std::vector<Box>& taken) {
  const LabelledPoint* last = nullptr;
  for (const LabelledPoint& point : points) {
    if (!point.on_line) continue;
    if (last != nullptr) {
      const double dx = point.x - last->x;
      const double dy = point.y - last->y;
      const int count = static_cast<int>(std::hypot(dx, dy) / step);
      for (int i = 1; i < count; ++i) {
        const double x = last->x + dx * i / count;
        const double y = last->y + dy * i / count;
        taken.push_back({x - step / 2, y - step / 2, x + step / 2, y + step / 2});
      }
    }
    last = &point;
  }
}

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<LabelledPoint>& points, double height,
                                     double width, double plot_height) {
  const double gap = 0.7 * height;
  const LabelPlace around[] = {{gap, 0, -1},
                               {gap, 0.75 * height, -1},
                               {gap, -0.75 * height, -1},
                               {0, 1.1 * height, 0},
                               {0, -1.1 * height, 0},
                               {-gap, 0, 1},
                               {-gap, 0.75 * height, 1},
                               {-gap, -0.75 * height, 1},
                               {0, 2.2 * height, 0},
                               {0, -2.2 * height, 0}};
  std::vector<Box> taken;
  for (const LabelledPoint& point : points) {
    const double r = 0.4 * height;
    taken.push_back({point.x - r, point.y - r, point.x + r, point.y + r});
  }
  take_line(points, 0.25 * height, taken);
  std::vector<LabelPlace> places;
  for (const LabelledPoint& point : points) {
    LabelPlace best = around[0];
    double least = std::numeric_limits<double>::infinity();
    for (const LabelPlace& place : around) {
      const Box box = box_of(point, place, height);
      const double outside = std::max(0.0, -box.left) + std::max(0.0, box.right - width) +
                             std::max(0.0, -box.bottom) + std::max(0.0, box.top - plot_height);
      double cost = outside * height;
      for (const Box& other : taken) cost += overlap(box, other);
      if (cost < least) least = cost, best = place;
    }
    places.push_back(best);
    taken.push_back(box_of(point, best, height));
  }
  return places;
}

}  // namespace fos::numerics
