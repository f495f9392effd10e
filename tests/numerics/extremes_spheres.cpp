// Extremes of spheres and of the camera: large, far, tiny, grazed, tied.
#include "extremes_families.hpp"
#include "scene_parts.hpp"

namespace fos::numerics {
namespace {

const std::string& lights() {
  static const std::string both =
      ambient("0.2") + point("0.6", "2, 1, 0") + directional("0.2", "1, 4, 4");
  return both;
}

/// From behind the camera, a little from the side.
const std::string& front_light() {
  static const std::string light = ambient("0.2") + directional("0.7", "1, 2, -3");
  return light;
}

}  // namespace

Family floor_radius() {
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, const std::string& y, const std::string& r) {
    cases.push_back(
        {name, canvas(33, 33) + three_spheres() + sphere("0, " + y + ", 0", r, 3) + lights(), {}});
  };
  for (int k = 1; k <= 15; ++k) {
    std::string y = "1" + std::string(static_cast<std::size_t>(k), '0');
    y.back() = '1';
    add(power(k), "-" + y, power(k));
    if (k == 3) add("5000", "-5001", "5000");
  }
  return scene_family("floor", text::extremes_floor, text::extremes_floor_finding,
                      std::move(cases));
}

Family sphere_far() {
  // Seen through a telescope whose view is 2.6 r wide there, a little off its axis. 700 and 1.6e7
  // are about where float and double begin to refuse it.
  std::vector<Case> cases;
  const auto add = [&](const std::string& distance, const std::string& view) {
    cases.push_back(
        {distance,
         canvas(24, 24) + viewport(view) + sphere("0.1, 0.2, " + distance, "1") + front_light(),
         {}});
  };
  for (int k = 1; k <= 9; ++k) {
    add(power(k), fmt::format("2.6e-{}", k));
    if (k == 2) add("700", "3.7e-3");
    if (k == 7) add("1.6e7", "1.6e-7");
  }
  return scene_family("far_sphere", text::extremes_far_sphere, text::extremes_far_sphere_finding,
                      std::move(cases));
}

Family unit_of_length() {
  std::vector<Case> cases;
  for (const int k : {-2600, -1230, -160, -150, -100, -30, -22, -19, -16, -12,  -6,  0,
                      6,     9,     12,   15,   18,   30,  76,  100, 153, 1230, 2466}) {
    const std::string e = "e" + std::to_string(k);
    std::string spheres = sphere("0, -1" + e + ", 3" + e, "1" + e, 1) +
                          sphere("2" + e + ", 0, 4" + e, "1" + e, 4) +
                          sphere("0, -5001" + e + ", 0", "5000" + e, 3);
    cases.push_back({power(k),
                     canvas(25, 25) + viewport(power(k), power(k)) + spheres + ambient("0.2") +
                         point("0.6", "2" + e + ", 1" + e + ", 0"),
                     {}});
  }
  return scene_family("unit", text::extremes_unit, text::extremes_unit_finding, std::move(cases));
}

Family grazing() {
  // The view is 10^-k wide, around a ray that is tangent to the sphere's top.
  std::vector<Case> cases;
  for (const int k : {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20}) {
    cases.push_back({power(-k),
                     canvas(25, 24) + viewport(power(-k)) + sphere("0, -1, 3", "1") + front_light(),
                     {}});
  }
  return scene_family("grazing", text::extremes_grazing, text::extremes_grazing_finding,
                      std::move(cases));
}

Family ties() {
  // Two spheres, of which the second is nearer by 10^-k, or by nothing: then the first is seen.
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, const std::string& z) {
    cases.push_back(
        {name,
         canvas(24, 24) + sphere("0, 0, " + z, "1", 1) + sphere("0, 0, 3", "1", 2) + front_light(),
         {}});
  };
  for (const int k : {1, 2, 4, 6, 7, 8, 10, 12, 14, 16, 18, 20}) add(power(-k), near(30, 10, k));
  add("0", "3");
  return scene_family("ties", text::extremes_ties, text::extremes_ties_finding, std::move(cases));
}

Family terminator() {
  // The view is 10^-k wide, around a point where the light only just grazes the surface.
  std::vector<Case> cases;
  for (const int k : {0, 1, 2, 3, 4, 6, 7, 8, 10, 14, 16, 18, 20}) {
    cases.push_back({power(-k),
                     canvas(24, 24) + viewport(power(-k)) + sphere("0, 0, 3", "1") +
                         ambient("0.2") + directional("0.7", "1, 0, 0"),
                     {}});
  }
  return scene_family("terminator", text::extremes_terminator, text::extremes_terminator_finding,
                      std::move(cases));
}

Family camera_and_sphere() {
  // Around a sphere of radius 2 at the origin, of which all that is seen lies in front of t = 1;
  // beyond 10 the view is a telescope's.
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, const std::string& z, const std::string& view) {
    cases.push_back({name,
                     canvas(24, 24) + viewport(view) + camera(z) + sphere("0, 0, 0", "2") +
                         ambient("0.2") + point("0.6", "3, 4, -5"),
                     {}});
  };
  for (const char* z : {"1", "0", "-1", "-1.999"}) add(z, z, "1");
  add("-2+1e-9", "-1.999999999", "1");
  add("-2", "-2", "1");
  add("-2-1e-9", "-2.000000001", "1");
  for (const char* z : {"-2.001", "-3", "-4"}) add(z, z, "1");
  for (int k = 1; k <= 9; ++k) add("-" + power(k), "-" + power(k), fmt::format("5e-{}", k));
  return scene_family("camera", text::extremes_camera, text::extremes_camera_finding,
                      std::move(cases));
}

Family canvas_limits() {
  std::vector<Case> cases;
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{1, 1}, {2, 1}, {3, 5}, {16384, 1}, {1, 16384}}) {
    cases.push_back({fmt::format("{}x{}", width, height),
                     canvas(width, height) + lecture_spheres() + lights(),
                     {}});
  }
  return scene_family("canvas", text::extremes_canvas, text::extremes_canvas_finding,
                      std::move(cases));
}

}  // namespace fos::numerics
