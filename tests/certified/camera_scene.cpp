#include "camera_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "exact_pixel.hpp"

namespace fos::certified {

double to_double(const mpq_class& x) {
  const auto bits = [](const mpz_class& n) {
    return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2));
  };
  const long exponent = bits(x.get_num()) - bits(x.get_den());  // GMP leaves overflow undefined
  if (exponent < -1000) return 0;
  if (exponent > 1000) return sgn(x) * std::numeric_limits<double>::infinity();
  return x.get_d();
}

namespace {

using Exact = mpq_class;
using ExactTriple = reference::Triple<mpq_class>;

/// (The operators on triples are found where their namespace is named: triples are arrays.)
ExactTriple difference(const ExactTriple& a, const ExactTriple& b) {
  using namespace reference;
  return a - b;
}

Triple to_doubles(const ExactTriple& x) {
  return {to_double(x[0]), to_double(x[1]), to_double(x[2])};
}
double length(const Triple& v) {
  return std::hypot(std::hypot(v[0], v[1]), v[2]);  // of three arguments it may be NaN for infinity
}

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Where along one axis of the canvas (pixels, `step` on the viewport each) a sphere in front of
/// the camera can be: the planes through that axis' pixels meet it between the two that touch it.
/// Vu is its centre's coordinate along the axis. Wider than the exact range by more than all
/// rounding.
Range extent(double Vu, double Vz, double r, double d, double step) {
  // Of normal numbers only, products included.
  const auto is_normal = [](double size) { return size >= 0x1p-200 && size <= 0x1p200; };
  if (!is_normal(Vz) || !is_normal(r) || !is_normal(d) || !is_normal(step) ||
      !(std::abs(Vu) <= 0x1p200)) {
    return {};
  }
  if (Vz - r <= 1e-3 * Vz) return {};  // it reaches the camera's own plane, or nearly
  const double below = (Vz - r) * (Vz + r);
  const double middle = Vu * Vz;
  const double half = r * std::sqrt(Vu * Vu + below);
  const double scale = d / (below * step);
  const double slack = 1 + 1e-9 * scale * (std::abs(middle) + half);
  if (!std::isfinite(slack)) return {};
  return {scale * (middle - half) - slack, scale * (middle + half) + slack};
}

int clamp_to(int limit, double x) {
  return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(limit)));
}

void set_row_form(const reference::ExactScene& scene, const ExactTriple& V, const Exact& c,
                  const Exact& r, CameraSphere& sphere) {
  const Exact kx = scene.viewport_width / scene.width;
  const Exact ky = scene.viewport_height / scene.height;
  const Exact& d = scene.projection_plane_d;
  const Exact p = c - V[0] * V[0];
  sphere.has_row_form = p != 0;
  if (!sphere.has_row_form) return;
  const Exact ratio = c / p;
  sphere.q = {to_double(ratio * d * d * (r * r - V[1] * V[1])),
              to_double(ratio * 2 * V[1] * V[2] * d * ky),
              to_double(ratio * ky * ky * (r * r - V[2] * V[2]))};
  const Exact shift = V[0] / (p * kx);
  sphere.xc = {to_double(shift * V[2] * d), to_double(shift * V[1] * ky)};
  sphere.k = to_double(p * kx * kx);
}

void set_shades(const ExactTriple& color, CameraSphere& sphere) {
  for (std::size_t i = 0; i < 3; ++i) {
    sphere.shade_of[i] = -1;
    if (color[i] == 0) continue;
    const auto same =
        std::find(color.begin(), color.begin() + static_cast<std::ptrdiff_t>(i), color[i]);
    const auto earlier = static_cast<std::size_t>(same - color.begin());
    if (earlier < i) {
      sphere.shade_of[i] = sphere.shade_of[earlier];
    } else {
      sphere.shade_of[i] = sphere.shade_count;
      const auto shade = static_cast<std::size_t>(sphere.shade_count++);
      sphere.shades[shade] = static_cast<float>(sphere.color[i]);
      sphere.unlit_shades[shade] = sphere.unlit[i];
    }
  }
}

/// Sizes that floats carry through all products here with neither overflow nor underflow.
bool is_moderate(double size) { return size >= 0x1p-20 && size <= 0x1p20; }

/// Whether the sphere's own numbers suit floats at all.
bool suits_float(const CameraScene& scene, const CameraSphere& sphere) {
  const double D = std::hypot(scene.kx * scene.width, scene.ky * scene.height, scene.d);
  return sphere.has_row_form && is_moderate(sphere.r) && is_moderate(scene.d) && is_moderate(D) &&
         sphere.V_length <= 0x1p20 && std::abs(sphere.c) >= 0x1p-20 &&
         std::abs(sphere.k) >= 0x1p-60 && std::abs(sphere.k) <= 0x1p60;
}

CameraSphere camera_sphere(const reference::ExactScene& scene, std::size_t index,
                           const Exact& unlit, double longest_D) {
  const reference::ExactSphere& exact = scene.spheres[index];
  const ExactTriple V = difference(exact.center, scene.camera);
  const Exact c = reference::squared_length(V) - exact.radius * exact.radius;
  const Exact& d = scene.projection_plane_d;
  CameraSphere sphere{};
  sphere.index = static_cast<int>(index);
  sphere.V = to_doubles(V);
  sphere.V_length = length(sphere.V);
  sphere.r = to_double(exact.radius);
  sphere.c = to_double(c);
  sphere.inside = c < 0;
  // All of it lies beyond the plane t = 1; or t = c/(h + s) >= c/2h >= 1, for no h is larger.
  const Exact half_width = scene.viewport_width / 2;
  const Exact half_height = scene.viewport_height / 2 + scene.viewport_height / scene.height;
  const Exact largest_h = abs(V[0]) * half_width + abs(V[1]) * half_height + abs(V[2]) * d;
  sphere.near_only = !sphere.inside && (V[2] - exact.radius >= d || 2 * largest_h <= c);
  const double ky = to_double(scene.viewport_height / scene.height);
  const double kx = to_double(scene.viewport_width / scene.width);
  sphere.h = {to_double(V[2] * d), to_double(V[1] * scene.viewport_height / scene.height)};
  sphere.hx = to_double(V[0] * scene.viewport_width / scene.width);
  set_row_form(scene, V, c, exact.radius, sphere);

  // ||V| − r| = |c| / (|V| + r), of the exact c: a difference of rounded lengths may be all
  // rounding.
  double to_surface = std::abs(sphere.c) / (sphere.V_length + sphere.r) / longest_D;
  if (!std::isfinite(sphere.c) || !std::isfinite(to_surface)) to_surface = 0;
  const double to_its_plane = to_double((V[2] - exact.radius) / d);
  // Less than all rounding, and in the range of float.
  const double nearest_t = sphere.inside ? to_surface : std::max(to_surface, to_its_plane);
  sphere.nearest_t = std::min(std::max(1.0, nearest_t * (1 - 1e-6)), 1e30);
  const Range rows = extent(sphere.V[1], sphere.V[2], sphere.r, to_double(d), ky);
  const Range columns = extent(sphere.V[0], sphere.V[2], sphere.r, to_double(d), kx);
  sphere.first_row = clamp_to(scene.height, scene.height / 2.0 - 1 - rows.high);
  sphere.end_row = clamp_to(scene.height, scene.height / 2.0 + 1 - rows.low);
  sphere.first_column = clamp_to(scene.width, columns.low + scene.width / 2.0);
  sphere.end_column = clamp_to(scene.width, columns.high + scene.width / 2.0 + 2);
  sphere.inv_r = static_cast<float>(1 / sphere.r);
  for (std::size_t i = 0; i < 3; ++i) sphere.W[i] = static_cast<float>(sphere.V[i] / sphere.r);
  sphere.color = to_doubles(exact.color);
  sphere.unlit = to_bytes(exact.color, unlit);
  set_shades(exact.color, sphere);
  return sphere;
}

Sight sight_of(const reference::ExactScene& scene, const CameraSphere& sphere) {
  const reference::ExactSphere& exact = scene.spheres[static_cast<std::size_t>(sphere.index)];
  if (exact.center[2] - scene.camera[2] + exact.radius < scene.projection_plane_d) {
    return Sight::before_plane;
  }
  const bool inside = sphere.first_row < sphere.end_row && sphere.first_column < sphere.end_column;
  return inside ? Sight::may_be_seen : Sight::outside_canvas;
}

CameraLight camera_light(const reference::ExactScene& scene, const reference::ExactLight& exact) {
  CameraLight light{exact.is_point, to_double(exact.intensity), {}, 0, {}, 0};
  ExactTriple L = exact.is_point ? difference(exact.vector, scene.camera) : exact.vector;
  light.M = to_doubles(L);
  light.M_length = length(light.M);
  // By its largest component first, so that no square leaves the range of double.
  const Exact largest = std::max({abs(L[0]), abs(L[1]), abs(L[2])});
  if (largest == 0) return light;
  for (Exact& component : L) component /= largest;
  light.direction = to_doubles(L);
  light.direction_length = length(light.direction);
  return light;
}

}  // namespace

CameraScene camera_scene(const reference::ExactScene& scene, reference::Terms terms) {
  const bool flat = (terms & reference::flat) != 0;
  const Exact I_A = (terms & reference::ambient) != 0 ? scene.ambient : Exact(0);
  const Exact unlit = flat ? Exact(1) : I_A;
  CameraScene out{};
  out.width = scene.width;
  out.height = scene.height;
  out.kx = to_double(scene.viewport_width / scene.width);
  out.ky = to_double(scene.viewport_height / scene.height);
  out.d = to_double(scene.projection_plane_d);
  out.ambient = to_double(I_A);
  out.background = to_bytes(scene.background_color, 1);

  out.longest_D = length({to_double(scene.viewport_width) / 2,
                          to_double(scene.viewport_height) / 2 + out.ky, out.d}) *
                  (1 + 1e-9);
  std::set<std::pair<ExactTriple, Exact>> known;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    CameraSphere sphere = camera_sphere(scene, i, unlit, out.longest_D);
    const bool is_new = known.emplace(scene.spheres[i].center, scene.spheres[i].radius).second;
    sphere.suits_float = suits_float(out, sphere);
    sphere.sight = is_new ? sight_of(scene, sphere) : Sight::repeated;
    out.spheres.push_back(sphere);
  }
  std::stable_sort(out.spheres.begin(), out.spheres.end(),
                   [](const auto& a, const auto& b) { return a.nearest_t < b.nearest_t; });
  if (flat) return out;
  for (const reference::ExactLight& light : scene.lights) {
    const reference::Term term = light.is_point ? reference::point : reference::directional;
    if ((terms & term) != 0 && light.intensity > 0)
      out.lights.push_back(camera_light(scene, light));
  }
  return out;
}

}  // namespace fos::certified
