// Every rung's kernel on the scenes of the reference tests, held to bounds that are derived from
// its precision; and wrong kernels, which the same bounds must catch.
#include <cstdint>
#include <filesystem>
#include <map>

#include "catch2.hpp"
#include "enclosure.hpp"
#include "interval_kernel.hpp"
#include "prepared.hpp"
#include "simd.hpp"
#include "slide_kernels.hpp"
#include "truth.hpp"

using namespace fos;
using namespace fos::numerics;

namespace {

SceneText scene(const std::string& name) {
  return read_scene_text(std::filesystem::path(FOS_TEST_SCENES) / (name + ".scene"));
}

const char* const names[] = {"crowd",       "extremes",   "front_lit", "inside", "light_on_surface",
                             "many_lights", "near_plane", "tangent",   "ties"};

/// Made once for all tests.
const Enclosure& enclosure(const std::string& name, int bits) {
  static std::map<std::pair<std::string, int>, Enclosure> made;
  const auto key = std::pair(name, bits);
  const auto found = made.find(key);
  return found != made.end() ? found->second
                             : made.emplace(key, Enclosure(scene(name), bits)).first->second;
}

template <class T>
Canvas<T> canvas_for(const SceneText& text) {
  return {text.canvas_width, text.canvas_height};
}

template <class T>
Canvas<T> slides(const SceneText& text) {
  auto canvas = canvas_for<T>(text);
  render_slides(rounded<T>(text), canvas);
  return canvas;
}

template <class T>
Canvas<T> prepared(const SceneText& text) {
  auto canvas = canvas_for<T>(text);
  render_prepared(prepare<T>(text), canvas);
  return canvas;
}

template <class T>
Canvas<T> simd(const SceneText& text) {
  auto canvas = canvas_for<T>(text);
  render_simd(prepare<T>(text), canvas);
  return canvas;
}

// The prepared formula rounds less than the slides', but in other places.
constexpr double other_formula = 1;
// 1/|N| and 1/|L|, each to 1.5 · 2^-12.
constexpr double twice_rsqrt = 3.1 / 4096;

}  // namespace

TEST_CASE("the slides' formula stays within its precision's enclosure") {
  for (const char* name : names) {
    INFO(name);
    const SceneText text = scene(name);
    CHECK(enclosure(name, 24).violations(slides<float>(text)) == 0);
    CHECK(enclosure(name, 53).violations(slides<double>(text)) == 0);
    CHECK(enclosure(name, 64).violations(slides<long double>(text)) == 0);
  }
}

TEST_CASE("prepared and SIMD rungs stay within the enclosure, with a margin for another formula") {
  for (const char* name : names) {
    INFO(name);
    const SceneText text = scene(name);
    const Enclosure& of_float = enclosure(name, 24);
    const Enclosure& of_double = enclosure(name, 53);
    CHECK(of_float.violations(prepared<float>(text), other_formula) == 0);
    CHECK(of_double.violations(prepared<double>(text), other_formula) == 0);
    CHECK(of_float.violations(simd<float>(text), other_formula) == 0);
    CHECK(of_double.violations(simd<double>(text), other_formula) == 0);
  }
}

TEST_CASE("mixed: the spheres of double, the light of float") {
  for (const char* name : names) {
    INFO(name);
    const SceneText text = scene(name);
    auto canvas = canvas_for<float>(text);
    render_mixed(rounded<double>(text), rounded<float>(text), canvas);
    CHECK(enclosure(name, 24).violations(canvas) == 0);
    CHECK(canvas.sphere == slides<double>(text).sphere);
  }
}

#ifdef __SSE__
TEST_CASE("the 12-bit 1/√x: the spheres of float, the light with its error") {
  for (const char* name : names) {
    INFO(name);
    const SceneText text = scene(name);
    auto canvas = canvas_for<float>(text);
    render_rsqrt(rounded<float>(text), canvas);
    CHECK(enclosure(name, 24).violations(canvas, 0, twice_rsqrt) == 0);
    CHECK(canvas.sphere == slides<float>(text).sphere);
  }
  CHECK(enclosure("ties", 24).violations([] {
    const SceneText text = scene("ties");
    auto canvas = canvas_for<float>(text);
    render_rsqrt(rounded<float>(text), canvas);
    return canvas;
  }()) > 0);  // without it, it is no float picture
}
#endif

TEST_CASE("intervals hold the truth, and decide nearly all pixels") {
  for (const char* name : names) {
    INFO(name);
    const SceneText text = scene(name);
    const Truth truth = truth_of(text);
    auto canvas = canvas_for<IntervalNumber>(text);
    render_intervals(to_intervals(text), canvas);
    long outside = 0;
    long open = 0;
    long lit = 0;
    for (std::size_t i = 0; i < canvas.size(); ++i) {
      const TruePixel& right = truth.pixels[i];
      if (canvas.sphere[i] == undecided) {
        ++open;
        continue;
      }
      const IntervalNumber I = canvas.I[i];
      if (canvas.sphere[i] != right.sphere) ++outside;
      if (right.sphere == 0) continue;
      ++lit;
      const bool holds = static_cast<long double>(I.low()) <= right.I.high &&
                         right.I.high <= static_cast<long double>(I.high());
      if (!holds) ++outside;
    }
    CHECK(outside == 0);
    CHECK(lit > 100);
    // Of equal spheres (ties) every pixel stays open.
    CHECK(open <= (std::string(name) == "ties" ? 300 : 12));
  }
}

TEST_CASE("a tangent ray, which no interval decides, is open and not guessed") {
  // Two of the rays that touch the lecture's red sphere, on a canvas that has them: (2/6, -1/4).
  SceneText text = read_scene_text(FOS_LECTURE_SCENE);
  text.canvas_width = 6;
  text.canvas_height = 4;
  auto canvas = canvas_for<IntervalNumber>(text);
  render_intervals(to_intervals(text), canvas);
  CHECK(canvas.sphere[2 * 6 + 5] == undecided);
  CHECK(canvas.sphere[2 * 6 + 1] == undecided);
  CHECK(canvas.sphere[2 * 6 + 3] == 1);
}

TEST_CASE("SIMD: rows that are no whole number of vectors, down to one pixel") {
  SceneText text = scene("many_lights");
  for (const int width : {1, 2, 3, 5, 7, 8, 9, 15, 16, 17, 31, 33}) {
    text.canvas_width = width;
    INFO(width);
    CHECK(Enclosure(text, 24).violations(simd<float>(text), other_formula) == 0);
    CHECK(Enclosure(text, 53).violations(simd<double>(text), other_formula) == 0);
  }
}

// Each with one mistake.
namespace wrong {

using Trace = Seen<double> (*)(const Vec<double>& D, const PreparedScene<double>& scene);

template <class Root, class Shade>
Seen<double> trace(const Vec<double>& D, const PreparedScene<double>& scene, Root root,
                   Shade shade) {
  double closest = INFINITY;
  std::size_t sphere = scene.spheres.size();
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const double t = root(dot(D, D), dot(scene.spheres[i].V, D), scene.spheres[i].c);
    if (t < closest) closest = t, sphere = i;
  }
  if (sphere == scene.spheres.size()) return {};
  const Vec<double> P = closest * D;
  const Vec<double> N = (P - scene.spheres[sphere].V) * scene.spheres[sphere].inverse_r;
  return {static_cast<int>(sphere) + 1, shade(P, N, scene)};
}

Canvas<double> render(const SceneText& text, Trace kernel) {
  auto canvas = canvas_for<double>(text);
  const PreparedScene<double> prepared_scene = prepare<double>(text);
  const SceneOf<double> view = rounded<double>(text);
  for_each_pixel(canvas, [&](int column, int row) {
    return kernel(canvas_to_viewport(view, column, row), prepared_scene);
  });
  return canvas;
}

Seen<double> none(const Vec<double>& D, const PreparedScene<double>& scene) {
  return trace(D, scene, nearest_root<double>, prepared_lighting<double>);
}
double near_only(double a, double h, double c) {
  const double discriminant = h * h - a * c;
  const double t = (h - std::sqrt(discriminant)) / a;
  return t >= 1 ? t : INFINITY;
}
Seen<double> near_root_only(const Vec<double>& D, const PreparedScene<double>& scene) {
  return trace(D, scene, near_only, prepared_lighting<double>);
}
Seen<double> before_the_plane(const Vec<double>& D, const PreparedScene<double>& scene) {
  const auto root = [](double a, double h, double c) {
    const double discriminant = h * h - a * c;
    const double t = (h - std::sqrt(discriminant)) / a;
    return t > 0 ? t : nearest_root(a, h, c);
  };
  return trace(D, scene, root, prepared_lighting<double>);
}
Seen<double> tangent_misses(const Vec<double>& D, const PreparedScene<double>& scene) {
  const auto root = [](double a, double h, double c) {
    return h * h - a * c > 0 ? nearest_root(a, h, c) : INFINITY;
  };
  return trace(D, scene, root, prepared_lighting<double>);
}
Seen<double> light_from_behind(const Vec<double>& D, const PreparedScene<double>& scene) {
  const auto shade = [](const Vec<double>& P, const Vec<double>& N,
                        const PreparedScene<double>& lit) {
    double i = prepared_lighting(P, N, lit);
    for (const auto& light : lit.directional_lights) {
      i += std::min(0.0, light.intensity * dot(N, light.vector));
    }
    return i;
  };
  return trace(D, scene, nearest_root<double>, shade);
}

}  // namespace wrong

TEST_CASE("the bounds catch wrong kernels") {
  const auto violations = [](const char* name, wrong::Trace kernel) {
    const SceneText text = scene(name);
    return enclosure(name, 53).violations(wrong::render(text, kernel), other_formula);
  };
  for (const char* name : names) CHECK(violations(name, wrong::none) == 0);
  CHECK(violations("inside", wrong::near_root_only) > 1000);
  CHECK(violations("near_plane", wrong::before_the_plane) > 10);
  CHECK(violations("tangent", wrong::tangent_misses) == 1);
  CHECK(violations("front_lit", wrong::light_from_behind) > 10);

  // A light a hundredth off its place, and float passed off as double.
  SceneText moved = scene("many_lights");
  const Enclosure& of_float = enclosure("many_lights", 24);
  const Enclosure& of_double = enclosure("many_lights", 53);
  moved.lights.front().vector[0] = parse_decimal("3.03");
  CHECK(of_float.violations(simd<float>(moved), other_formula) > 1000);
  auto canvas = canvas_for<double>(moved);
  const Canvas<float> coarse = slides<float>(scene("many_lights"));
  canvas.sphere = coarse.sphere;
  canvas.I.assign(coarse.I.begin(), coarse.I.end());
  CHECK(of_double.violations(canvas, other_formula) > 1000);
}

TEST_CASE("a huge sphere: prepared float keeps the digits that the slides' float loses") {
  const SceneText text = read_scene_text(FOS_LECTURE_SCENE);
  SceneText small = text;
  small.canvas_width = small.canvas_height = 60;
  const Truth truth = truth_of(small);
  const auto mean_error = [&](const Canvas<float>& canvas) {
    long double sum = 0;
    for (std::size_t i = 0; i < canvas.size(); ++i) {
      if (canvas.sphere[i] == truth.pixels[i].sphere && canvas.sphere[i] != 0) {
        sum += std::abs(static_cast<long double>(canvas.I[i]) - truth.pixels[i].I.high);
      }
    }
    return sum / static_cast<long double>(canvas.size());
  };
  CHECK(mean_error(prepared<float>(small)) < mean_error(slides<float>(small)) / 2);
}
