#include <memory>

#include "certified.hpp"
#include "fos/text.hpp"
#include "interval_kernel.hpp"
#include "prepared.hpp"
#include "rung.hpp"
#include "simd.hpp"
#include "slide_kernels.hpp"

namespace fos::numerics {
namespace {

template <class T>
using ColorOf = std::conditional_t<std::is_same_v<T, IntervalNumber>, long double, T>;

/// A rung that renders into a canvas of T.
template <class T, class Render>
Rung rung(const char* id, const Text& name, const SceneText& text, Render render) {
  auto canvas = std::make_shared<Canvas<T>>(text.canvas_width, text.canvas_height);
  auto colors = colors_of<ColorOf<T>>(text);
  return {id, say(name), [canvas, render = std::move(render)] { render(*canvas); },
          [canvas, colors = std::move(colors)](const Truth& truth) {
            return errors_of(*canvas, truth, colors);
          }};
}

template <class T>
Rung slides_rung(const char* id, const Text& name, const SceneText& text) {
  return rung<T>(id, name, text,
                 [scene = rounded<T>(text)](Canvas<T>& canvas) { render_slides(scene, canvas); });
}

template <class T>
Rung prepared_rung(const char* id, const Text& name, const SceneText& text) {
  return rung<T>(id, name, text,
                 [scene = prepare<T>(text)](Canvas<T>& canvas) { render_prepared(scene, canvas); });
}

template <class T>
Rung simd_rung(const char* id, const Text& name, const SceneText& text) {
  return rung<T>(id, name, text,
                 [scene = prepare<T>(text)](Canvas<T>& canvas) { render_simd(scene, canvas); });
}

/// Delivers bytes, each proven; what its floats make of I on the way is nobody's answer.
Rung certified_rung(const SceneText& text) {
  constexpr reference::Terms all_light =
      reference::ambient | reference::point | reference::directional;
  auto renderer = std::make_shared<certified::Renderer>(text, all_light);
  auto picture = std::make_shared<certified::Picture>();
  return {"certified", say(text::trade_certified), [=] { renderer->render(*picture); },
          [picture](const Truth& truth) { return errors_of(picture->rgb, truth); }};
}

}  // namespace

std::vector<Rung> ladder(const SceneText& text) {
  std::vector<Rung> rungs;
#ifdef __SSE__
  rungs.push_back(rung<float>(
      "rsqrt", text::trade_rsqrt, text,
      [scene = rounded<float>(text)](Canvas<float>& canvas) { render_rsqrt(scene, canvas); }));
#endif
  rungs.push_back(slides_rung<float>("float", text::trade_float, text));
  rungs.push_back(prepared_rung<float>("float_prepared", text::trade_float_prepared, text));
  rungs.push_back(simd_rung<float>("float_simd", text::trade_float_simd, text));
  rungs.push_back(rung<float>(
      "mixed", text::trade_mixed, text,
      [scene = rounded<double>(text), shading = rounded<float>(text)](Canvas<float>& canvas) {
        render_mixed(scene, shading, canvas);
      }));
  rungs.push_back(slides_rung<double>(baseline_id, text::trade_double, text));
  rungs.push_back(prepared_rung<double>("double_prepared", text::trade_double_prepared, text));
  rungs.push_back(simd_rung<double>("double_simd", text::trade_double_simd, text));
  rungs.push_back(slides_rung<long double>("long_double", text::trade_long_double, text));
  rungs.push_back(certified_rung(text));
  rungs.push_back(
      rung<IntervalNumber>("intervals", text::trade_intervals, text,
                           [scene = to_intervals(text)](Canvas<IntervalNumber>& canvas) {
                             render_intervals(scene, canvas);
                           }));
  return rungs;
}

}  // namespace fos::numerics
