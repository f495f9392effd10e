#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fos::certified {

double replacement_bound(double reach, double distance) {
  // L = M − P turns away from M by the angle at the light, whose sine is at most reach/distance.
  // Two unit vectors at that angle are 2 sin(half of it) apart, and max(0, ⟨N,·⟩) moves no more.
  const double sine = reach / distance;
  return sine < 1 ? 2 * std::sin(std::asin(sine) / 2) : 2;
}

double reach(const CameraSphere& sphere) {
  // The near root is never beyond the tangents, which are √c long.
  return sphere.near_only ? std::sqrt(sphere.c) : sphere.V_length + sphere.r;
}

double reach(const CameraScene& scene) {
  double farthest = 0;
  for (const CameraSphere& sphere : scene.spheres) {
    if (sphere.sight == Sight::may_be_seen) farthest = std::max(farthest, reach(sphere));
  }
  return farthest;
}

Plan plan(const CameraScene& scene) {
  Plan plan;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    if (scene.spheres[i].sight != Sight::may_be_seen) continue;
    plan.spheres.push_back(static_cast<int>(i));
  }
  plan.shade = !scene.lights.empty();
  const double farthest = reach(scene);
  for (const CameraLight& light : scene.lights) {
    const double bound = light.is_point ? replacement_bound(farthest, light.M_length) : 2;
    plan.replaced.push_back(bound <= replacement_budget ? bound : -1);
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
