// A stage program that is wrong in ways that are no formula: FOS_ODD names one. Its picture
// is that of no light, the colors as they are.
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string_view>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace fos {
namespace {

bool is(std::string_view name) {
  static const char* const value = std::getenv("FOS_ODD");
  return value != nullptr && name == value;
}

}  // namespace

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  static int calls = 0;
  ++calls;
  if (is("prints")) std::cout << "N = " << D << '\n' << "to cout\n", std::cerr << "to cerr\n";
  if (is("crashes")) std::raise(SIGSEGV);
  if (is("crashes later") && calls > 1000) std::raise(SIGSEGV);
  if (is("exits later") && calls > 1000) std::_Exit(0);
  if (is("exits")) std::_Exit(3);
  if (is("throws")) throw std::runtime_error("no such thing");
  volatile bool for_ever = is("never ends") || (is("never ends later") && calls > 1000);
  while (for_ever) {
  }
  const auto hit = closest_hit(O, D, t_min, t_max, scene);
  if (!hit) return scene.background_color;
  if (is("unwritten")) return unwritten("trace_ray");
  if (is("counts")) return hit->sphere->color * (calls > 1000 ? Real(0.5) : Real(1));
  if (is("crashes in one light") && scene.point_lights.size() == 1 && scene.ambient_intensity == 0)
    std::raise(SIGFPE);
  Real I = 1;
  if (is("lit") || is("crashes in one light")) {
    const Vec3 P = O + hit->t * D;
    const Vec3 N = normalize(P - hit->sphere->center);
    I = scene.ambient_intensity;
    for (const PointLight& light : scene.point_lights) {
      const Vec3 L = light.position - P;
      if (dot(N, L) > 0) I += light.intensity * dot(N, L) / length(L);
    }
  }
  return hit->sphere->color * I;
}

}  // namespace fos
