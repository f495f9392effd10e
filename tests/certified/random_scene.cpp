#include "random_scene.hpp"

#include <fmt/core.h>

#include <initializer_list>
#include <vector>

#include "random_numbers.hpp"

namespace fos::certified {
namespace {

std::string color(Random& random) {
  const auto channel = [&]() -> std::string {
    if (random.once_in(4)) return "0";
    if (random.once_in(4)) return "255";
    return random.once_in(3) ? fmt::format("{}.5", random.below(255)) : random.number(0, 255);
  };
  return fmt::format("({}, {}, {})", channel(), channel(), channel());
}

std::string sphere(Random& random, const std::string& center, const std::string& radius) {
  return fmt::format("sphere {{ center = {} radius = {} color = {} }}\n", center, radius,
                     color(random));
}

/// A number that differs from a whole one, if at all, by less and less.
std::string almost(Random& random, int whole) {
  static constexpr const char* nines = "99999999999999999999999999";
  const int digits = random.between(5, 20);
  if (random.once_in(3)) return std::to_string(whole);
  return random.once_in(2)
             ? fmt::format("{}.{}{}", whole, std::string(static_cast<std::size_t>(digits), '0'),
                           random.between(1, 9))
             : fmt::format("{}.{:.{}}", whole - 1, nines, digits);
}

/// Spheres on a knife's edge along the axis: tangent to it, touching the plane t = 1, or met at the
/// same t as another; and a color between two bytes.
std::string edge_spheres(Random& random) {
  const std::string z = std::to_string(random.between(3, 9));
  switch (random.below(4)) {
    case 0: {
      const int scale = random.between(1, 3);
      return sphere(random, fmt::format("({}, {}, {})", 3 * scale, -4 * scale, z),
                    almost(random, 5 * scale));
    }
    case 1:
      return sphere(random, "(0, 0, " + almost(random, 3) + ")", "2");
    case 2:
      return sphere(random, "(0, 0, 5)", "1") +
             sphere(random, "(0, 0, " + almost(random, 7) + ")", "3");
    default:
      return "sphere { center = (0, 0, " + z + ") radius = 1 color = (127.5, 254.5, 0.5) }\n" +
             "light { type = directional intensity = " + almost(random, 1) +
             " direction = (0, 0, -1) }\n";
  }
}

/// A floor at a slant, so that what cancels does not cancel in one coordinate.
std::string slanted_floor(Random& random) {
  const int scale = random.between(10, 99999);
  return sphere(
      random,
      fmt::format("({}{}.{}, -{}.{}, {})", random.once_in(2) ? "-" : "", 3 * scale,
                  random.below(10), 4 * scale, random.between(1, 9), random.between(-2, 5)),
      std::to_string(5 * scale));
}

std::string random_sphere(Random& random) {
  switch (random.below(13)) {
    case 0: {  // a floor, a ceiling or a wall: a large sphere nearly through the camera
      const int exponent = random.between(1, 9);
      const std::string radius = fmt::format("{}e{}", random.between(1, 9), exponent);
      const std::string far =
          fmt::format("-{}{:0{}}.{}", radius[0], random.between(1, 2), exponent, random.below(10));
      const std::string near = random.number(-3, 3);
      const int axis = random.below(3);
      const std::string& height =
          axis == 2 ? far.substr(1) : (random.once_in(2) ? far : far.substr(1));
      return sphere(random,
                    axis == 0   ? fmt::format("({}, {}, 5)", height, near)
                    : axis == 1 ? fmt::format("({}, {}, 5)", near, height)
                                : fmt::format("({}, 0, {})", near, height),
                    radius);
    }
    case 1:  // around the camera
      return sphere(random, random.triple(2, 2, -2, 2), random.number(4, 30));
    case 2: {  // small and far
      const int exponent = random.between(1, 7);
      return sphere(random, random.triple(2, 2, 5, 9, exponent),
                    random.number(1, 2, exponent - random.between(0, 4)));
    }
    case 3:  // tiny, near the plane t = 1
      return sphere(random, random.triple(1, 1, 1, 3), random.number(1, 900, -3));
    case 4:  // whole numbers: tangent rays, equal roots
      return sphere(random, random.whole_triple(4, 1, 8), std::to_string(random.between(1, 5)));
    case 5:  // across the plane t = 1
      return sphere(random, random.triple(2, 2, 0, 3), random.number(1, 3));
    case 7:
      return slanted_floor(random);
    case 6:  // of any size at all
      return sphere(random, random.triple(9, 9, 1, 9, random.between(-9, 9)),
                    random.number(1, 9, random.between(-9, 9)));
    default:
      return sphere(random, random.triple(4, 3, 2, 9), random.number(1, 2));
  }
}

std::string random_light(Random& random) {
  const std::string I =
      random.once_in(8) ? random.number(1, 9, random.between(-9, 6)) : random.number(0, 1);
  if (random.once_in(2)) {
    std::string direction = random.once_in(4) ? random.whole_triple(3, -3, 3)
                                              : random.triple(4, 4, -4, 4, random.between(-40, 40));
    if (direction == "(0, 0, 0)" || direction.find("(0e") == 0) direction = "(1, 4, -4)";
    return fmt::format("light {{ type = directional intensity = {} direction = {} }}\n", I,
                       direction);
  }
  const std::string position = random.once_in(4) ? random.triple(9, 9, -9, 9, random.between(0, 30))
                               : random.once_in(4) ? random.whole_triple(4, 0, 8)
                                                   : random.triple(5, 5, -5, 9);
  return fmt::format("light {{ type = point intensity = {} position = {} }}\n", I, position);
}

}  // namespace

std::string random_scene(std::uint64_t seed, int size) {
  Random random(seed);
  std::string scene = fmt::format("canvas_size = {} x {}\n", size, size);
  if (random.once_in(3)) {
    scene += fmt::format("viewport_size = {} x {}\nprojection_plane_d = {}\n", random.number(1, 2),
                         random.number(1, 2), random.number(1, 3));
  }
  if (random.once_in(3)) {
    scene += "camera_position = " + random.triple(9, 9, -9, 9, random.between(-2, 3)) + "\n";
  }
  if (random.once_in(2)) scene += "background_color = " + color(random) + "\n";
  std::vector<std::string> spheres;
  const int count = random.once_in(20) ? random.between(20, 60) : random.between(1, 6);
  for (int i = 0; i < count; ++i) {
    const bool repeat = !spheres.empty() && random.once_in(25);
    spheres.push_back(repeat ? spheres.back() : random_sphere(random));
  }
  for (const std::string& each : spheres) scene += each;
  if (random.once_in(4)) scene += edge_spheres(random);
  if (!random.once_in(4)) {
    scene += fmt::format("light {{ type = ambient intensity = {} }}\n", random.number(0, 1));
  }
  const int lights = random.once_in(15) ? random.between(10, 40) : random.below(4);
  for (int i = 0; i < lights; ++i) scene += random_light(random);
  return scene;
}

}  // namespace fos::certified
