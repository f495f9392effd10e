#include "light_code.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fos {
namespace {

constexpr double steps = 512;
constexpr LightCode last_code = 1 + 2000;  // I = 18
constexpr double slack = 0.1;

double value(double scale) {
  const double s = (scale - 1) / steps;
  return s < 1 ? s : std::exp(s - 1);
}

}  // namespace

double light_scale(double I) {
  if (std::isnan(I)) return -1;
  if (I <= 0) return 0;
  return std::min<double>(last_code, 1 + steps * (I < 1 ? I : 1 + std::log(I)));
}

LightCode light_code(double I) {
  const double scale = light_scale(I);
  return scale < 0 ? not_a_number_code : static_cast<LightCode>(scale);
}

LightCell light_cell(LightCode code) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double low = code == 0 ? -infinity : value(code - slack);
  const double high = code == 0 ? value(1 + slack) : value(code + 1 + slack);
  return {low, code >= last_code ? infinity : high};
}

}  // namespace fos
