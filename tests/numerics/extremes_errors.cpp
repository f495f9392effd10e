#include "extremes_errors.hpp"

#include <algorithm>
#include <cmath>

#include "exact_hit.hpp"
#include "fos/frame.hpp"

namespace fos::numerics {
namespace {

std::uint8_t byte_of(long double I) { return to_byte(255 * I); }

int sphere_along(const reference::ExactScene& scene, const mpq_class& x, const mpq_class& y) {
  const auto hit = reference::exact_hit(
      scene, {mpq_class(x * scene.viewport_width / scene.width),
              mpq_class(y * scene.viewport_height / scene.height), scene.projection_plane_d});
  return hit ? hit->sphere + 1 : 0;
}

}  // namespace

bool Measure::is_boundary(std::size_t pixel, int sphere) const {
  const auto width = static_cast<std::size_t>(truth_.width);
  const mpq_class x = exact_.canvas_x(static_cast<int>(pixel % width));
  const mpq_class y = exact_.canvas_y(static_cast<int>(pixel / width));
  const mpq_class step(1, 1000);
  const auto shows = [&](const mpq_class& dx, const mpq_class& dy) {
    return sphere_along(exact_, x + dx, y + dy) == sphere;
  };
  return shows(-step, 0) || shows(step, 0) || shows(0, -step) || shows(0, step);
}

Errors Measure::operator()(const std::vector<Said>& said) const {
  Errors errors;
  long double sum = 0;
  long measured = 0;
  errors.pixels = static_cast<long>(said.size());
  for (std::size_t i = 0; i < said.size(); ++i) {
    const TruePixel& truth = truth_.pixels[i];
    if (!said[i].finite) {
      ++errors.not_finite;
      ++errors.wrong_bytes;
    } else if (said[i].sphere != truth.sphere) {
      if (is_boundary(i, said[i].sphere)) {
        ++errors.boundary;
      } else {
        ++errors.wrong_spheres;
        ++errors.wrong_bytes;
      }
    } else {
      const long double I = truth.I.high;
      const long double error = std::abs(said[i].I - I - truth.I.low) / std::max(1.0L, std::abs(I));
      errors.max = std::max(errors.max, static_cast<double>(error));
      sum += error;
      ++measured;
      if (byte_of(said[i].I) != byte_of(I)) ++errors.wrong_bytes;
    }
  }
  if (measured > 0) errors.mean = static_cast<double>(sum / static_cast<long double>(measured));
  return errors;
}

}  // namespace fos::numerics
