#include "fos/scene_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "fos/nearest.hpp"
#include "fos/text.hpp"

namespace fos {
namespace {

/// Where the limits are worked out: wider than Real in range, so that they do not overflow first.
using Wide = long double;
using Limits = std::numeric_limits<Real>;

constexpr std::string_view real_name = std::same_as<Real, float>    ? "float"
                                       : std::same_as<Real, double> ? "double"
                                                                    : "long double";

using WideVec3 = glm::vec<3, Wide>;

WideVec3 wide(const DecimalTriple& triple) { return nearest<Wide>(triple); }

/// √(min/ε): a length from here on up has a square that keeps all its digits.
Wide smallest_length() {
  return std::sqrt(static_cast<Wide>(Limits::min()) / static_cast<Wide>(Limits::epsilon()));
}

/// Checks that the scene's numbers go through the slides' formulas; the header lists the
/// conditions.
class RangeCheck {
 public:
  explicit RangeCheck(const SceneText& text)
      : text_(text),
        O_(wide(text.camera_position)),
        d_(nearest<Wide>(text.projection_plane_d)),
        longest_D_(length(WideVec3(nearest<Wide>(text.viewport_size[0]) / 2,
                                   nearest<Wide>(text.viewport_size[1]) / 2, d_))) {}

  void operator()() {
    camera();
    for (const SphereText& each : text_.spheres) sphere(each);
    Wide total = 0;
    for (const LightText& light : text_.lights) {
      const Wide I = nearest<Wide>(light.intensity);
      if (light.kind == LightKind::point) point_light(light);
      at_most(light.intensity, "intensity", I, max_ / (2 * largest_radius_ * longest_L_));
      total += I;
      at_most(light.intensity, "intensity", total, max_ / 1024);
    }
  }

 private:
  void camera() {
    // a >= d², and every a that is met keeps its digits.
    at_least(text_.projection_plane_d, "projection_plane_d", d_, smallest_length());
    const Wide longest = std::sqrt(max_ / 8) / 1024;
    at_most(text_.projection_plane_d, "projection_plane_d", d_, longest);
    const std::array canvas{text_.canvas_width, text_.canvas_height};
    for (std::size_t i = 0; i < 2; ++i) {
      const Decimal& size = text_.viewport_size[i];
      const Wide pixels = canvas[i];
      at_most(size, "viewport_size", nearest<Wide>(size), longest);
      at_least(size, "viewport_size", nearest<Wide>(size), 2 * pixels * smallest_coordinate());
    }
    for (const Decimal& coordinate : text_.camera_position) {
      at_most(coordinate, "camera_position", std::abs(nearest<Wide>(coordinate)), longest);
      not_tiny(coordinate, "camera_position");
    }
  }

  void sphere(const SphereText& each) {
    const Wide r = nearest<Wide>(each.radius);
    const WideVec3 C = wide(each.center);
    const Wide OC = length(C - O_);
    // b² <= (2 S |D|)² and 4ac <= 4 |D|² S²; where |D| < 1, c and |N|² are larger, up to S². Then
    // t = (−b ± √disc)/2a <= 2 S/d stays finite too, with d as large as it must be.
    const Wide largest = std::sqrt(max_ / 8) / std::max<Wide>(1, longest_D_);
    const bool center_leads = OC > r;
    at_most(center_leads ? farthest(each.center) : each.radius, center_leads ? "center" : "radius",
            OC + r, largest);
    at_least(each.radius, "radius", r, smallest_length() / std::min<Wide>(1, 2 * d_));
    // In b² − 4ac the sphere adds 4 a r² to squares of about a |OC|², which carry a relative error
    // of some ε: from |OC| = r / (4 √ε) on, the chord could round to nothing or to all of |OC|, and
    // P land on the centre. P itself is a sum of numbers as large as O and C.
    const Wide epsilon = Limits::epsilon();
    const Wide smallest =
        std::max(4 * std::sqrt(epsilon) * OC, 16 * epsilon * (length(O_) + length(C)));
    if (!(r >= smallest)) {
      fail(each.radius.place, say(text::scene_sphere_too_far, {real_name, number(smallest)}));
    }
    farthest_P_ = std::max(farthest_P_, 2 * (length(C) + r));
    largest_radius_ = std::max(largest_radius_, r);
  }

  void point_light(const LightText& light) {
    const WideVec3 position = wide(light.vector);
    const Wide limit = std::sqrt(max_) / 2 - farthest_P_;
    const Wide distance = length(position);
    if (!(distance <= limit)) {
      const Decimal& largest = farthest(light.vector);
      // The same direction in numbers near 1; what is too small beside the largest becomes 0.
      std::array<std::string, 3> direction;
      for (std::size_t i = 0; i < 3; ++i) {
        Decimal scaled = light.vector[i];
        scaled.exponent -= largest.exponent + static_cast<long>(largest.digits.size()) - 1;
        direction[i] = fmt::format("{:.6g}", nearest<double>(scaled));
      }
      fail(largest.place,
           say(text::scene_light_too_far, {real_name, number(limit), light.intensity.text,
                                           direction[0], direction[1], direction[2]}));
    }
    for (const Decimal& coordinate : light.vector) not_tiny(coordinate, "position");
    longest_L_ = std::max(longest_L_, distance + farthest_P_);
  }

  /// A coordinate of L is a difference of such numbers, so it is 0 or at least about ε/2 of the
  /// smallest of them; its square must not vanish.
  static Wide smallest_coordinate() {
    return 2 * std::sqrt(static_cast<Wide>(Limits::min())) / static_cast<Wide>(Limits::epsilon());
  }
  void not_tiny(const Decimal& coordinate, std::string_view key) const {
    if (coordinate.is_zero()) return;
    if (std::abs(nearest<Wide>(coordinate)) < smallest_coordinate()) {
      fail(coordinate.place,
           say(text::scene_too_small_or_zero, {key, real_name, number(smallest_coordinate())}));
    }
  }

  /// The largest of three numbers, by size.
  static const Decimal& farthest(const DecimalTriple& triple) {
    const auto size = [](Decimal decimal) {
      decimal.negative = false;
      return decimal;
    };
    return *std::max_element(triple.begin(), triple.end(), [&](const auto& a, const auto& b) {
      return compare(size(a), size(b)) < 0;
    });
  }

  static std::string number(Wide value) { return fmt::format("{:.2g}", value); }

  void at_most(const Decimal& decimal, std::string_view key, Wide value, Wide limit) const {
    if (!(value <= limit)) {
      fail(decimal.place, say(text::scene_too_large, {key, real_name, number(limit)}));
    }
  }
  void at_least(const Decimal& decimal, std::string_view key, Wide value, Wide limit) const {
    if (!(value >= limit)) {
      fail(decimal.place, say(text::scene_too_small, {key, real_name, number(limit)}));
    }
  }
  [[noreturn]] void fail(Place place, const std::string& message) const {
    throw scene_error(text_.source, text_.name, place, message);
  }

  const SceneText& text_;
  WideVec3 O_;
  Wide d_;
  Wide longest_D_;
  Wide max_ = Limits::max();
  Wide farthest_P_ = 0;
  Wide largest_radius_ = 1;
  Wide longest_L_ = 2;  // a rescaled direction is at most √3 long
};

/// `direction` with its largest component in [1/2, 1), by an exact power of two, for any exponent
/// that long double reaches.
Vec3 rescaled(const DecimalTriple& direction) {
  const WideVec3 exact = wide(direction);
  const Wide largest = std::max({std::abs(exact.x), std::abs(exact.y), std::abs(exact.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  Vec3 out;
  for (int i = 0; i < 3; ++i) {
    const Decimal& decimal = direction[static_cast<std::size_t>(i)];
    // Where Real holds the number itself, it is rounded once and scaling is exact.
    const Real direct = nearest<Real>(decimal);
    out[i] = std::isnormal(direct) ? std::ldexp(direct, -exponent)
                                   : static_cast<Real>(std::ldexp(exact[i], -exponent));
  }
  return out;
}

}  // namespace

SceneFile to_scene(const SceneText& text) {
  RangeCheck{text}();
  SceneFile file;
  View& view = file.view;
  view.canvas_width = text.canvas_width;
  view.canvas_height = text.canvas_height;
  view.viewport_width = nearest<Real>(text.viewport_size[0]);
  view.viewport_height = nearest<Real>(text.viewport_size[1]);
  view.projection_plane_d = nearest<Real>(text.projection_plane_d);
  view.camera_position = nearest<Real>(text.camera_position);

  Scene& scene = file.scene;
  scene.background_color = nearest<Real>(text.background_color);
  for (const SphereText& sphere : text.spheres) {
    scene.spheres.push_back(
        {nearest<Real>(sphere.center), nearest<Real>(sphere.radius), nearest<Real>(sphere.color)});
  }
  for (const LightText& light : text.lights) {
    const Real intensity = nearest<Real>(light.intensity);
    if (light.kind == LightKind::ambient) {
      scene.ambient_intensity = intensity;
    } else if (light.kind == LightKind::point) {
      scene.point_lights.push_back({intensity, nearest<Real>(light.vector)});
    } else {
      scene.directional_lights.push_back({intensity, rescaled(light.vector)});
    }
  }
  return file;
}

}  // namespace fos
