#include "light_code.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fos {
namespace {

constexpr double steps = 512;
constexpr int zero = 4096;   // the code of I = 0
constexpr int reach = 2000;  // codes on either side of it, to |I| = 18
constexpr double slack = 0.1;

double value(double scale) {
  const double s = std::abs(scale - zero) / steps;
  return std::copysign(s < 1 ? s : std::exp(s - 1), scale - zero);
}

}  // namespace

double light_scale(double I) {
  const double size = std::abs(I);
  const double s = steps * (size < 1 ? size : 1 + std::log(size));
  return std::isnan(I) ? I : zero + std::clamp<double>(std::copysign(s, I), -reach, reach);
}

LightCode light_code(double I) {
  const double scale = light_scale(I);
  return std::isnan(scale) ? not_a_number_code : static_cast<LightCode>(std::floor(scale));
}

LightCell light_cell(LightCode code) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {code <= zero - reach ? -infinity : value(code - slack),
          code >= zero + reach ? infinity : value(code + 1 + slack)};
}

}  // namespace fos
