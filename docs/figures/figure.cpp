#include "figure.hpp"

#include <algorithm>
#include <cstddef>

namespace fos {
namespace {

constexpr std::size_t fixed_count = 11;
constexpr std::size_t whole_count = 7;
constexpr double most = 16384;

/// Takes them from the front.
class Numbers {
 public:
  explicit Numbers(std::span<const double> numbers) : rest_(numbers) {}

  Real real() {
    const double first = rest_.front();
    rest_ = rest_.subspan(1);
    return static_cast<Real>(first);
  }
  int whole() { return static_cast<int>(real()); }
  std::size_t count() { return static_cast<std::size_t>(real()); }
  Vec3 vector() {
    const Real x = real();
    const Real y = real();
    return {x, y, real()};
  }

 private:
  std::span<const double> rest_;
};

}  // namespace

std::optional<Figure> figure_of(std::span<const double> numbers) {
  if (numbers.size() < fixed_count) return std::nullopt;
  const auto whole = numbers.first(whole_count);
  if (!std::all_of(whole.begin(), whole.end(), [](double n) { return 0 <= n && n <= most; })) {
    return std::nullopt;
  }
  Numbers next(numbers);
  Figure figure;
  figure.mistake = next.whole();
  figure.terms = static_cast<unsigned>(next.whole());
  figure.view.canvas_width = next.whole();
  figure.view.canvas_height = next.whole();
  Scene& scene = figure.scene;
  const std::size_t spheres = next.count();
  const std::size_t points = next.count();
  const std::size_t directionals = next.count();
  if (numbers.size() != fixed_count + 7 * spheres + 4 * (points + directionals)) {
    return std::nullopt;
  }
  scene.spheres.resize(spheres);
  scene.point_lights.resize(points);
  scene.directional_lights.resize(directionals);
  scene.ambient_intensity = next.real();
  scene.background_color = next.vector();
  for (Sphere& sphere : scene.spheres) {
    sphere.center = next.vector();
    sphere.radius = next.real();
    sphere.color = next.vector();
  }
  for (PointLight& light : scene.point_lights) {
    light.intensity = next.real();
    light.position = next.vector();
  }
  for (DirectionalLight& light : scene.directional_lights) {
    light.intensity = next.real();
    light.direction = next.vector();
  }
  return figure;
}

Figure& shown_figure() {
  static Figure figure;
  return figure;
}

}  // namespace fos
