// Wrong programs, each a right one with a single mistake: FOS_MISTAKE names it. All of them must
// fail.
#include <cstdlib>
#include <glm/common.hpp>
#include <string_view>
#include <utility>

#include "fos/stage.hpp"

namespace fos {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

const std::string_view mistake = variable("FOS_MISTAKE");
const std::string_view terms = variable("FOS_TERMS");  // some of "apd", or "1" for the plain color

bool is(std::string_view name) { return mistake == name; }
bool has(char term) { return terms.find(term) != std::string_view::npos; }

std::pair<Real, Real> intersect_ray_sphere(const Vec3& O, const Vec3& D, const Sphere& sphere) {
  const Vec3 CO = is("O_forgotten") ? -sphere.center : O - sphere.center;
  const Real r = sphere.radius;
  const Real a = dot(D, D);
  const Real b = (is("b_without_2") ? Real(1) : Real(2)) * dot(CO, D);
  const Real c = dot(CO, CO) - (is("r_not_squared") ? r : r * r);
  const Real disc = b * b - (is("without_4") ? Real(1) : Real(4)) * a * c;
  if (disc < 0 || (is("tangent_misses") && disc <= 0)) return {infinity, infinity};
  const Real below = is("divided_by_2") ? 2 : is("divided_by_a") ? a : 2 * a;
  const Real root = std::sqrt(disc);
  const Real near_t = (-b - root) / below;
  const Real far_t = (-b + root) / below;
  if (is("near_root_only")) return {near_t, infinity};
  if (is("far_root_only")) return {far_t, infinity};
  return {near_t, far_t};
}

Real term(Real intensity, const Vec3& P, const Vec3& N, const Vec3& L) {
  Real n_dot_l = dot(N, L);
  if (is("absolute_cosine")) n_dot_l = std::abs(n_dot_l);
  if (n_dot_l <= 0 && !is("negative_kept")) return 0;
  if (is("L_not_normalised")) return intensity * n_dot_l / length(N);
  if (is("divided_by_L_squared")) return intensity * n_dot_l / (length(N) * dot(L, L));
  if (is("N_not_normalised")) return intensity * n_dot_l / length(L);
  const Real cosine = length(L) > 0 ? n_dot_l / (length(N) * length(L)) : 0;
  if (is("angle_for_cosine")) return intensity * std::acos(std::min<Real>(1, cosine));
  if (is("cosine_squared")) return intensity * cosine * cosine;
  if (is("falloff")) return intensity * cosine / std::max<Real>(1, dot(L, L));
  if (is("all_or_nothing")) return intensity;
  if (is("distance_to_camera")) return intensity * cosine / std::max<Real>(1, length(P));
  return intensity * cosine;
}

Real compute_lighting(const Vec3& P, const Vec3& N, const Scene& scene) {
  Real i = has('a') && !is("ambient_forgotten") ? scene.ambient_intensity : 0;
  if (is("ambient_twice")) i *= 2;
  auto add = [&, first = true, count = 0](Real part) mutable {
    if (is("three_lights") && ++count > 3) return;
    if (is("last_light_only")) {
      i = part;
    } else if (is("lights_multiplied")) {
      i *= part;
    } else if (is("brightest_light")) {
      i = std::max(i, part);
    } else if (!(is("first_light_only") && !first)) {
      i += part;
    }
    if (is("ambient_per_light") && !first) i += scene.ambient_intensity;
    first = false;
  };
  if (has('p')) {
    for (const PointLight& light : scene.point_lights) {
      Vec3 L = light.position - P;
      if (is("L_reversed")) L = P - light.position;
      if (is("L_is_position")) L = light.position;
      if (is("light_moved")) L.x += Real(0.02) * std::max<Real>(1, std::abs(light.position.x));
      add(term(light.intensity, P, N, L));
    }
  }
  if (has('d') && !is("directional_forgotten")) {
    for (const DirectionalLight& light : scene.directional_lights) {
      Vec3 L = light.direction;
      if (is("direction_negated")) L = -L;
      if (is("direction_is_position")) L = L - P;
      add(term(light.intensity, P, N, L));
    }
  }
  const std::size_t others = scene.point_lights.size() + scene.directional_lights.size();
  if (is("ambient_twice_alone") && others == 0) i *= 2;
  if (is("lit_without_lights") && others == 0 && scene.ambient_intensity == 0) i = 1;
  if (is("cut_off_at_1")) i = std::min<Real>(1, i);
  if (is("gamma")) i = std::sqrt(std::max<Real>(0, i));
  if (is("a_percent_more")) i *= Real(1.01);
  return i;
}

Color shade(const Vec3& O, const Vec3& D, Real t, const Sphere& sphere, const Scene& scene) {
  const Vec3 P = is("P_without_O") ? t * D : is("P_is_D") ? O + D : O + t * D;
  Vec3 N = P - sphere.center;
  if (is("N_inward")) N = -N;
  if (is("N_is_P")) N = P;
  if (is("N_is_D")) N = D;
  if (!is("N_not_normalised")) N = N / length(N);
  if (has('1')) return sphere.color;
  const Real I = compute_lighting(P, N, scene);
  if (is("color_plus_I")) return sphere.color + Color(I);
  if (is("light_without_color")) return Color(255 * I);
  if (is("color_without_light")) return sphere.color;
  return sphere.color * I;
}

}  // namespace

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  if (is("t_min_ignored")) t_min = 0;
  if (is("t_min_behind")) t_min = -infinity;
  const Vec3 ray = is("upside_down") ? Vec3(D.x, -D.y, D.z) : D;
  if (is("t_min_nearly")) t_min = Real(0.9);
  Real closest_t = is("last_sphere") ? 0 : is("far_is_1000") ? 1000 : infinity;
  const Sphere* closest = nullptr;
  for (const Sphere& sphere : scene.spheres) {
    if (is("eight_spheres") && &sphere - scene.spheres.data() >= 8) break;
    if (is("centre_behind_skipped") && sphere.center.z < O.z) continue;
    const auto [t1, t2] = intersect_ray_sphere(O, ray, sphere);
    for (const Real t : {std::min(t1, t2), std::max(t1, t2)}) {
      const bool counts = is("open_interval") ? t_min < t && t < t_max : t_min <= t && t <= t_max;
      const bool nearer = is("last_of_equals") ? t <= closest_t : t < closest_t;
      const bool taken = is("last_sphere")    ? t < infinity
                         : is("first_sphere") ? closest == nullptr && t < infinity
                                              : nearer;
      if (counts && taken) closest_t = t, closest = &sphere;
      if (is("last_sphere") && counts) break;
    }
  }
  if (closest == nullptr && is("whole_background")) return floor(scene.background_color);
  if (closest == nullptr) return is("black_background") ? Color(0) : scene.background_color;
  Color color = shade(O, ray, closest_t, *closest, scene);
  const Real brightest = std::max({color.r, color.g, color.b});
  if (is("hue_kept") && brightest > 255) color = color * (255 / brightest);
  if (is("channels_swapped")) std::swap(color.r, color.b);
  if (is("truncated")) color = floor(color);
  if (is("rounded")) color = round(color);
  if (is("not_a_number")) color.g += std::sqrt(color.r - 10) * 0;
  return color;
}

}  // namespace fos
