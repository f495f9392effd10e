#include "exact_scene.hpp"

#include <cstdlib>
#include <stdexcept>

namespace fos::reference {
namespace {

constexpr long max_exponent = 10000;

Triple<mpq_class> to_exact(const DecimalTriple& decimals) {
  return {reference::to_exact(decimals[0]), reference::to_exact(decimals[1]),
          reference::to_exact(decimals[2])};
}

}  // namespace

// (A quotient and no mpq_class(width, 2): that would stay 600/2, and GMP's == and its arithmetic
// are for fractions in lowest terms.)
mpq_class ExactScene::canvas_x(int column) const { return column - mpq_class(width) / 2; }

mpq_class ExactScene::canvas_y(int row) const { return mpq_class(height) / 2 - 1 - row; }

mpq_class to_exact(const Decimal& decimal) {
  if (decimal.is_zero()) return 0;
  if (decimal.exponent < -max_exponent || decimal.exponent > max_exponent) {
    throw std::range_error("the number " + decimal.text + " is too large or too small");
  }
  mpq_class result{mpz_class(decimal.digits, 10)};
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(decimal.exponent)));
  if (decimal.exponent < 0) {
    result /= power;
  } else {
    result *= power;
  }
  return decimal.negative ? mpq_class(-result) : result;
}

ExactScene to_exact(const SceneText& scene) {
  ExactScene exact{.width = scene.canvas_width,
                   .height = scene.canvas_height,
                   .viewport_width = to_exact(scene.viewport_size[0]),
                   .viewport_height = to_exact(scene.viewport_size[1]),
                   .projection_plane_d = to_exact(scene.projection_plane_d),
                   .camera = to_exact(scene.camera_position),
                   .background_color = to_exact(scene.background_color),
                   .spheres = {},
                   .ambient = 0,
                   .lights = {}};
  for (const SphereText& sphere : scene.spheres) {
    exact.spheres.push_back(
        {to_exact(sphere.center), to_exact(sphere.radius), to_exact(sphere.color)});
  }
  for (const LightText& light : scene.lights) {
    if (light.kind == LightKind::ambient) {
      exact.ambient = to_exact(light.intensity);
    } else {
      exact.lights.push_back(
          {light.kind == LightKind::point, to_exact(light.intensity), to_exact(light.vector)});
    }
  }
  return exact;
}

}  // namespace fos::reference
