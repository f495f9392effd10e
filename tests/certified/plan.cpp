#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fos::certified {
namespace {

/// A replaced light may be off by about what floats lose anyway (eight roundings), so that few
/// pixels more are left undecided.
constexpr double budget = 0x1p-21;

}  // namespace

double replacement_bound(double reach, double distance) {
  // L = M − P turns away from M by the angle at the light, whose sine is at most reach/distance.
  // Two unit vectors at that angle are 2 sin(half of it) apart, and max(0, ⟨N,·⟩) moves no more.
  const double sine = reach / distance;
  return sine < 1 ? 2 * std::sin(std::asin(sine) / 2) : 2;
}

double reach(const CameraSphere& sphere) {
  // From outside the near root is seen, never beyond the tangents, which are √c long.
  return sphere.inside ? sphere.V_length + sphere.r : std::sqrt(sphere.c);
}

Plan plan(const CameraScene& scene) {
  Plan plan;
  double farthest = 0;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    if (!scene.spheres[i].may_be_seen) continue;
    plan.spheres.push_back(static_cast<int>(i));
    farthest = std::max(farthest, reach(scene.spheres[i]));
  }
  plan.shade = !scene.lights.empty();
  for (const CameraLight& light : scene.lights) {
    const double bound = light.is_point ? replacement_bound(farthest, light.M_length) : 2;
    plan.replaced.push_back(bound <= budget ? bound : -1);
  }
  return plan;
}

Plan general_plan(const CameraScene& scene) {
  Plan plan;
  plan.spheres.resize(scene.spheres.size());
  std::iota(plan.spheres.begin(), plan.spheres.end(), 0);
  plan.within_outlines = false;
  plan.replaced.assign(scene.lights.size(), -1);
  return plan;
}

}  // namespace fos::certified
