#include "drawn_scene.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "random_numbers.hpp"

namespace fos::grading {
namespace {

using certified::Random;

std::string number(long thousandths) { return fmt::format("{}e-3", thousandths); }

std::string triple(const Thousandths& v) {
  return fmt::format("({}, {}, {})", number(v[0]), number(v[1]), number(v[2]));
}

std::string color(const std::array<int, 3>& c) {
  return fmt::format("({}, {}, {})", c[0], c[1], c[2]);
}

std::array<int, 3> draw_color(Random& random) {
  // Three numbers that differ, so that swapped channels show.
  const int low = random.between(10, 80);
  std::array<int, 3> channels{low, low + random.between(20, 70), 255 - random.between(0, 60)};
  std::swap(channels[static_cast<std::size_t>(random.below(3))], channels[2]);
  std::swap(channels[static_cast<std::size_t>(random.below(2))], channels[1]);
  return channels;
}

long even(Random& random, int low, int high) { return 2L * random.between(low / 2, high / 2); }

Thousandths moved(Thousandths v, const Thousandths& by) {
  for (std::size_t i = 0; i < 3; ++i) v[i] += by[i];
  return v;
}

/// About one line of sight, so that some hide others.
void add_spheres(DrawnScene& scene, Random& random) {
  const int count = random.between(3, 5);
  for (int i = 0; i < count; ++i) {
    const long radius = random.between(500, 1300);
    const long distance = random.between(3600, 7000);
    scene.spheres.push_back(
        {moved({random.between(-1900, 1900), random.between(-1100, 1100), distance}, scene.camera),
         radius, draw_color(random)});
  }
  if (random.once_in(2)) {  // a floor
    const long radius = 1000L * random.between(400, 4000);
    scene.spheres.push_back({moved({0, -radius - random.between(1100, 1500), 0}, scene.camera),
                             radius, draw_color(random)});
  }
  if (random.once_in(3)) {  // behind the camera
    scene.spheres.push_back(
        {moved({random.between(-500, 500), 0, -random.between(3000, 6000)}, scene.camera),
         random.between(400, 1500), draw_color(random)});
  }
}

Thousandths draw_direction(Random& random) {
  // More often from the camera's side, where what it lights is seen.
  return {random.between(-3000, 3000), random.between(-1000, 4000),
          random.once_in(4) ? random.between(500, 3000) : -random.between(500, 3000)};
}

void add_lights(DrawnScene& scene, Random& random) {
  scene.ambient = even(random, 60, 240);
  for (const bool is_point : {true, false}) {
    const int count = random.between(1, 3);
    for (int i = 0; i < count; ++i) {
      const Thousandths vector =
          is_point ? moved({random.between(-3500, 3500), random.between(-500, 3500),
                            random.between(-2500, 2500)},
                           scene.camera)
                   : draw_direction(random);
      scene.lights.push_back({is_point, even(random, 100, 700) / count / 2 * 2, vector});
    }
  }
}

}  // namespace

std::string DrawnScene::text() const {
  // A pixel is as wide as it is high, 1/64 of the plane at d = 1.
  std::string out = fmt::format(
      "canvas_size = {} x {}\nviewport_size = {}e-3 x 1\ncamera_position = {}\nbackground_color = "
      "{}\n",
      width, height, 1000L * width / height, triple(camera), color(background));
  for (const DrawnSphere& sphere : spheres) {
    out += fmt::format("sphere {{ center = {}  radius = {}  color = {} }}\n", triple(sphere.center),
                       number(sphere.radius), color(sphere.color));
  }
  if (ambient > 0)
    out += fmt::format("light {{ type = ambient  intensity = {} }}\n", number(ambient));
  for (const DrawnLight& light : lights) {
    out += fmt::format("light {{ type = {}  intensity = {}  {} = {} }}\n",
                       light.is_point ? "point" : "directional", number(light.intensity),
                       light.is_point ? "position" : "direction", triple(light.vector));
  }
  return out;
}

DrawnScene draw_scene(std::uint64_t seed, int number) {
  Random random(seed ^ (0x9E3779B97F4A7C15U * (static_cast<std::uint64_t>(number) + 1)));
  DrawnScene scene;
  if (number > 0) {
    scene.camera = {random.between(-2000, 2000), random.between(-1000, 1000),
                    random.between(-2000, 2000)};
  }
  scene.background = draw_color(random);
  add_spheres(scene, random);
  add_lights(scene, random);
  return scene;
}

DrawnScene changed(const DrawnScene& scene, Relation relation) {
  DrawnScene other = scene;
  switch (relation) {
    case Relation::mirrored:
      other.camera[0] = -other.camera[0];
      for (DrawnSphere& sphere : other.spheres) sphere.center[0] = -sphere.center[0];
      for (DrawnLight& light : other.lights) light.vector[0] = -light.vector[0];
      break;
    case Relation::dimmed:
      other.ambient /= 2;
      for (DrawnLight& light : other.lights) light.intensity /= 2;
      break;
    case Relation::reordered:
      std::reverse(other.spheres.begin(), other.spheres.end());
      std::reverse(other.lights.begin(), other.lights.end());
      break;
  }
  return other;
}

}  // namespace fos::grading
