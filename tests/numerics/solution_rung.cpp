#include "solution_rung.hpp"

#include <algorithm>
#include <memory>

#include "fos/render.hpp"
#include "fos/scene_file.hpp"
#include "fos/text.hpp"

namespace fos::numerics {
namespace {

struct Picture {
  SceneFile file;
  std::vector<Color> colors;
};

void render_into(Picture& picture) {
  auto next = picture.colors.begin();
  render(picture.file.scene, picture.file.view, [&](auto colors, auto /*unwritten*/) {
    next = std::copy(colors.begin(), colors.end(), next);
  });
}

Frame to_frame(const Picture& picture) {
  const View& view = picture.file.view;
  Frame frame;
  frame.header = {view.canvas_width, view.canvas_height, Precision::binary64};
  for (const Color& color : picture.colors) {
    for (int i = 0; i < 3; ++i) frame.channels.push_back(color[i]);
  }
  return frame;
}

}  // namespace

Rung solution_rung(const SceneText& scene) {
  const auto picture = std::make_shared<Picture>(Picture{to_scene(scene), {}});
  picture->colors.resize(static_cast<std::size_t>(scene.canvas_width) *
                         static_cast<std::size_t>(scene.canvas_height));
  return {"solution_combined", say(text::trade_solution), [picture] { render_into(*picture); },
          [picture, colors = colors_of<double>(scene)](const Truth& truth) {
            return errors_of(to_frame(*picture), truth, colors);
          }};
}

}  // namespace fos::numerics
