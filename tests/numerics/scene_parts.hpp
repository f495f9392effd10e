// The text of scenes, in parts.
#pragma once

#include <fmt/core.h>
#include <gmpxx.h>

#include <string>
#include <vector>

namespace fos::numerics {

inline std::string canvas(int width, int height) {
  return fmt::format("canvas_size = {} x {}\n", width, height);
}
/// A view of `size` in height and width at distance `d`, of which a small one is a telescope.
inline std::string viewport(const std::string& size, const std::string& d = "1") {
  return fmt::format("viewport_size = {0} x {0}\nprojection_plane_d = {1}\n", size, d);
}
inline std::string camera(const std::string& z) {
  return fmt::format("camera_position = (0, 0, {})\n", z);
}
/// Colors of 0 and 255, of which no two are alike, so that a picture says which sphere it shows.
inline std::string sphere(const std::string& center, const std::string& radius, int number = 1) {
  return fmt::format("sphere {{ center = ({}) radius = {} color = ({}, {}, {}) }}\n", center,
                     radius, number & 1 ? 255 : 0, number & 2 ? 255 : 0, number & 4 ? 255 : 0);
}
inline std::string ambient(const std::string& I) {
  return fmt::format("light {{ type = ambient intensity = {} }}\n", I);
}
inline std::string point(const std::string& I, const std::string& position) {
  return fmt::format("light {{ type = point intensity = {} position = ({}) }}\n", I, position);
}
inline std::string directional(const std::string& I, const std::string& direction) {
  return fmt::format("light {{ type = directional intensity = {} direction = ({}) }}\n", I,
                     direction);
}

/// The spheres of the lecture's scene; the floor may be another.
inline std::string three_spheres() {
  return sphere("0, -1, 3", "1", 1) + sphere("2, 0, 4", "1", 4) + sphere("-2, 0, 4", "1", 2);
}
inline std::string lecture_spheres() { return three_spheres() + sphere("0, -5001, 0", "5000", 3); }

/// 10^k, written as 1ek.
inline std::string power(int k) { return fmt::format("1e{}", k); }

/// a/10 + b 10^-k / 10, all digits.
inline std::string near(int a, int b, int k) {
  mpz_class digits;
  mpz_ui_pow_ui(digits.get_mpz_t(), 10, static_cast<unsigned long>(k));
  digits = a * digits + b;
  return fmt::format("{}e{}", digits.get_str(), -k - 1);
}

/// (x, y, z) 10^k.
inline std::string times_power(int x, int y, int z, int k) {
  return fmt::format("{}e{}, {}e{}, {}e{}", x, k, y, k, z, k);
}

}  // namespace fos::numerics
