#include "float_lights.hpp"

#include "row_sphere.hpp"

namespace fos::certified {
namespace {

/// Up to here a plain sum of the lights' terms is good enough.
constexpr double few = 4;

}  // namespace

FloatLights float_lights(const CameraScene& scene, const std::vector<double>& replaced) {
  const double U = u;
  FloatLights lights;
  lights.suit = scene.ambient == 0 || (scene.ambient >= 0x1p-40 && scene.ambient <= 0x1p40);
  lights.ambient = static_cast<float>(scene.ambient);
  double brightest = scene.ambient;
  for (const CameraLight& light : scene.lights) brightest += light.I;
  lights.brightest = static_cast<float>(brightest * (1 + 1e-6));
  // The ambient light and the colors round once each, the channel and its two ends three times; a
  // plain sum rounds once a light, a compensated one about twice in all.
  const auto count = static_cast<double>(scene.lights.size());
  lights.many = count > few;
  lights.sum_share = static_cast<float>(U * (6.2 + (lights.many ? 2.2 : count)));
  lights.error_share += static_cast<float>(1.1 * U * count);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const CameraLight& light = scene.lights[i];
    const bool as_directional = !light.is_point || replaced[i] >= 0;
    if (light.I < 0x1p-40 || light.I > 0x1p40 || (!as_directional && light.M_length > 0x1p40)) {
      lights.suit = false;
      return lights;
    }
    const auto I = static_cast<float>(light.I);
    if (as_directional) {
      const double difference = light.is_point ? 1.01 * replaced[i] : 0;
      const auto scaled = [&](std::size_t axis) {
        return static_cast<float>(light.I * light.direction[axis] / light.direction_length);
      };
      lights.directional.push_back(
          {I, scaled(0), scaled(1), scaled(2), static_cast<float>(light.I * (5 * U + difference))});
    } else {
      const auto M = [&](std::size_t axis) { return static_cast<float>(light.M[axis]); };
      lights.point.push_back({I, M(0), M(1), M(2), static_cast<float>(1.1 * U * light.M_length),
                              static_cast<float>(18 * U * light.I)});
    }
  }
  return lights;
}

}  // namespace fos::certified
