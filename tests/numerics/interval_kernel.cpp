#include "interval_kernel.hpp"

#include <mpfr.h>

#include "exact_scene.hpp"

namespace fos::numerics {
namespace {

using reference::Triple;

IntervalNumber to_interval(const mpq_class& exact) {
  mpfr_t end;
  mpfr_init2(end, std::numeric_limits<double>::digits);
  mpfr_set_q(end, exact.get_mpq_t(), MPFR_RNDD);
  const double low = mpfr_get_d(end, MPFR_RNDD);
  mpfr_set_q(end, exact.get_mpq_t(), MPFR_RNDU);
  const double high = mpfr_get_d(end, MPFR_RNDU);
  mpfr_clear(end);
  return {low, high};
}

IntervalTriple to_interval(const Triple<mpq_class>& v) {
  return {to_interval(v[0]), to_interval(v[1]), to_interval(v[2])};
}

IntervalTriple operator-(const IntervalTriple& a, const IntervalTriple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
IntervalNumber dot(const IntervalTriple& a, const IntervalTriple& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
IntervalNumber square_length(const IntervalTriple& v) {
  return square(v.x) + square(v.y) + square(v.z);
}

IntervalTriple canvas_to_viewport(const IntervalScene& scene, int column, int row) {
  const IntervalNumber W = scene.width;
  const IntervalNumber H = scene.height;
  const IntervalNumber x = column - scene.width / 2.0;  // exact
  const IntervalNumber y = scene.height / 2.0 - 1 - row;
  return {x * scene.viewport_width / W, y * scene.viewport_height / H, scene.projection_plane_d};
}

/// The closest sphere so far; `sure` as long as no other answer is possible.
struct Closest {
  int sphere = -1;
  IntervalNumber t = std::numeric_limits<double>::infinity();
  bool sure = true;

  void consider(int candidate, IntervalNumber candidate_t) {
    if (candidate_t.high() < t.low()) {
      sphere = candidate, t = candidate_t, sure = true;
    } else if (candidate_t.low() <= t.high()) {
      sure = false;  // either; the lower end is what a later sphere has to beat
      t = {std::min(t.low(), candidate_t.low()), std::min(t.high(), candidate_t.high())};
    }
  }
};

/// The search of trace_ray. A root counts where it is certainly >= 1. Where that is open, or
/// whether there is a root at all, the pixel stays open unless something certain is nearer.
Closest closest_sphere(const IntervalScene& scene, const IntervalTriple& D) {
  Closest closest;
  const IntervalNumber a = square_length(D);
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const IntervalScene::Sphere& sphere = scene.spheres[i];
    const IntervalTriple CO = scene.O - sphere.center;
    const IntervalNumber b = 2.0 * dot(CO, D);
    const IntervalNumber c = square_length(CO) - square(sphere.radius);
    const IntervalNumber discriminant = square(b) - 4.0 * a * c;
    if (discriminant.high() < 0) continue;
    const IntervalNumber root = sqrt(discriminant);
    const IntervalNumber near = (-b - root) / (2.0 * a);
    const IntervalNumber far = (-b + root) / (2.0 * a);
    if (far.high() < 1) continue;
    const bool certain = discriminant.low() >= 0;
    if (certain && near.low() >= 1) {
      closest.consider(static_cast<int>(i), near);
    } else if (certain && near.high() < 1 && far.low() >= 1) {
      closest.consider(static_cast<int>(i), far);
    } else {
      const double first = near.low() >= 1 ? near.low() : 1.0;
      if (first > closest.t.high()) continue;
      // As near as `first`, or not there at all.
      closest.sure = false;
      closest.t = {std::min(closest.t.low(), first), closest.t.high()};
    }
  }
  return closest;
}

IntervalNumber compute_lighting(const IntervalTriple& P, const IntervalTriple& N,
                                const IntervalScene& scene) {
  IntervalNumber i = scene.ambient_intensity;
  for (const IntervalScene::Light& light : scene.lights) {
    const IntervalTriple L = light.is_point ? light.vector - P : light.vector;
    const IntervalNumber n_dot_l = positive_part(dot(N, L));
    if (n_dot_l.high() <= 0) continue;
    const IntervalNumber lengths = sqrt(square_length(N)) * sqrt(square_length(L));
    i = i + positive_part(light.intensity * n_dot_l / lengths);
  }
  return i;
}

}  // namespace

IntervalScene to_intervals(const SceneText& text) {
  const reference::ExactScene exact = reference::to_exact(text);
  IntervalScene scene{exact.width,
                      exact.height,
                      to_interval(exact.viewport_width),
                      to_interval(exact.viewport_height),
                      to_interval(exact.projection_plane_d),
                      to_interval(exact.camera),
                      {},
                      to_interval(exact.ambient),
                      {}};
  for (const reference::ExactSphere& sphere : exact.spheres) {
    scene.spheres.push_back({to_interval(sphere.center), to_interval(sphere.radius)});
  }
  for (const reference::ExactLight& light : exact.lights) {
    scene.lights.push_back(
        {light.is_point, to_interval(light.intensity), to_interval(light.vector)});
  }
  return scene;
}

void render_intervals(const IntervalScene& scene, Canvas<IntervalNumber>& out) {
  const RoundUpward upward;
  std::size_t i = 0;
  for (int row = 0; row < scene.height; ++row) {
    for (int column = 0; column < scene.width; ++column, ++i) {
      const IntervalTriple D = canvas_to_viewport(scene, column, row);
      const Closest closest = closest_sphere(scene, D);
      out.sphere[i] = closest.sure ? closest.sphere + 1 : undecided;
      out.I[i] = 1.0;
      if (!closest.sure || closest.sphere < 0) continue;
      const IntervalTriple tD{closest.t * D.x, closest.t * D.y, closest.t * D.z};
      const IntervalTriple P{scene.O.x + tD.x, scene.O.y + tD.y, scene.O.z + tD.z};
      const IntervalTriple CP = P - scene.spheres[static_cast<std::size_t>(closest.sphere)].center;
      const IntervalNumber length = sqrt(square_length(CP));
      const IntervalTriple N{CP.x / length, CP.y / length, CP.z / length};
      out.I[i] = compute_lighting(P, N, scene);
    }
  }
}

}  // namespace fos::numerics
