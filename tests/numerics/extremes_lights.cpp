// Extremes of lights: far, near, strong, weak and many.
#include "extremes_families.hpp"
#include "scene_parts.hpp"

namespace fos::numerics {
namespace {

/// The lecture's scene with an ambient light of 0.2 and one other. An odd canvas has no ray that is
/// exactly tangent to a sphere, which any rounding may take for a miss.
std::string lecture_with(const std::string& light, int side = 33) {
  return canvas(side, side) + lecture_spheres() + ambient("0.2") + light;
}

// (1, 4, 4) / √33, the lecture's direction, times the Sun's distance in metres.
constexpr const char* sun_position = "2.6042e10, 1.04168e11, 1.04168e11";

}  // namespace

Family point_light_far() {
  std::vector<Case> cases;
  for (const int k : {0,  1,  2,  4,   6,   8,   10,  12,  14,  16,  18,  19,   20,   30,
                      37, 38, 60, 100, 152, 153, 154, 200, 300, 308, 320, 2465, 2467, 4900}) {
    cases.push_back({power(k), lecture_with(point("0.6", times_power(1, 4, 4, k))), {}});
  }
  return scene_family("far_light", text::extremes_far_light, text::extremes_far_light_finding,
                      std::move(cases));
}

Family sun() {
  const std::string as_point = lecture_with(point("0.6", sun_position));
  const std::string as_directional = lecture_with(directional("0.6", "1, 4, 4"));
  return scene_family("sun", text::extremes_sun, text::extremes_sun_finding,
                      {{"point", as_point, {}}, {"direct.", as_directional, as_point}});
}

Family replaced() {
  std::vector<Case> cases;
  for (const int k : {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18}) {
    cases.push_back({power(k), lecture_with(directional("0.6", "1, 4, 4")),
                     lecture_with(point("0.6", times_power(1, 4, 4, k)))});
  }
  return scene_family("replaced", text::extremes_replaced, text::extremes_replaced_finding,
                      std::move(cases));
}

Family light_near_surface() {
  // The pixel (12, 13) of 24 looks along (0, -1/12, 1) and meets the sphere at P = (0, -0.2, 2.4),
  // where N = (0, 0.8, -0.6). The light is at P + 10^-k ((1, 0, 0) + N): at 45 degrees to it.
  std::vector<Case> cases;
  for (const int k : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 15, 16, 18, 19, 20, 30, 300}) {
    const std::string light = power(-k) + ", " + near(-2, 8, k) + ", " + near(24, -6, k);
    cases.push_back(
        {power(-k),
         canvas(24, 24) + sphere("0, -1, 3", "1") + ambient("0.2") + point("0.6", light),
         {}});
  }
  const std::string at_P =
      canvas(24, 24) + sphere("0, 0, 3", "1") + ambient("0.2") + point("0.6", "0, 0, 2");
  cases.push_back({"0", at_P, {}});
  return scene_family("near_light", text::extremes_near_light, text::extremes_near_light_finding,
                      std::move(cases));
}

Family direction_length() {
  std::vector<Case> cases;
  for (const int k : {-4900, -300, -170, -162, -154, -45, -40, -25, -23, -19,  -10, 0,
                      10,    18,   19,   30,   38,   100, 153, 154, 300, 2466, 4900}) {
    cases.push_back({power(k), lecture_with(directional("0.6", times_power(1, 4, 4, k))), {}});
  }
  return scene_family("length", text::extremes_length, text::extremes_length_finding,
                      std::move(cases));
}

Family bright() {
  std::vector<Case> cases;
  for (const int k : {-4940, -320, -300, -46, -45, -40, -20, -3,  0,   3,
                      10,    20,   30,   35,  36,  37,  38,  300, 306, 308}) {
    cases.push_back({power(k),
                     canvas(25, 25) + lecture_spheres() + point(power(k), "2, 1, 0") +
                         directional(power(k), "1, 4, 4"),
                     {}});
  }
  return scene_family("bright", text::extremes_bright, text::extremes_bright_finding,
                      std::move(cases));
}

Family many_lights() {
  std::vector<Case> cases;
  for (const int n : {1, 10, 100, 1000, 10000}) {
    std::string scene = canvas(6, 6) + lecture_spheres();
    for (int i = 0; i < n; ++i) {
      scene += point(fmt::format("{:.6e}", 0.9 / n),
                     fmt::format("{}, {}, {}", i % 7 - 3, 1 + i % 5, -(i % 11)));
    }
    cases.push_back({std::to_string(n), scene, {}});
  }
  return scene_family("lights", text::extremes_lights, text::extremes_lights_finding,
                      std::move(cases));
}

}  // namespace fos::numerics
