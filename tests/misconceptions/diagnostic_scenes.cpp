#include "diagnostic_scenes.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <string>

namespace fos {
namespace {

/// Where a place of the source lies, in bytes; lights stand in lines of ASCII.
std::size_t offset(const std::string& source, Place place) {
  std::size_t at = 0;
  for (int line = 1; line < place.line; ++line) at = source.find('\n', at) + 1;
  return at + static_cast<std::size_t>(place.column - 1);
}

/// The scene with only the lights that are `kept`.
SceneText with_lights(const SceneText& scene, const std::function<bool(std::size_t)>& kept) {
  std::string source = scene.source;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (kept(i)) continue;
    const std::size_t begin = offset(source, scene.lights[i].place);
    source.replace(begin, source.find('}', begin) + 1 - begin, source.find('}', begin) + 1 - begin,
                   ' ');
  }
  return parse_scene_text(source, scene.name);
}

unsigned term_of(LightKind kind) {
  if (kind == LightKind::ambient) return ambient_term;
  return kind == LightKind::point ? point_term : directional_term;
}

}  // namespace

const std::vector<SceneText>& base_scenes() {
  static const std::vector<SceneText> scenes = [] {
    std::vector<SceneText> read;
    for (const char* name : {"room", "open", "bright"}) {
      const std::filesystem::path folder = FOS_DIAGNOSTIC_SCENES;
      read.push_back(read_scene_text(folder / (std::string(name) + ".scene")));
      read.back().name = std::string(name) + ".scene";
    }
    return read;
  }();
  return scenes;
}

std::size_t pixels_of(const SceneText& scene) {
  return static_cast<std::size_t>(scene.canvas_width) *
         static_cast<std::size_t>(scene.canvas_height);
}

std::vector<SceneText> diagnostic_scenes(const Stage& stage) {
  std::vector<SceneText> scenes = base_scenes();
  constexpr unsigned both = point_term | directional_term;
  if ((stage.terms & both) != both) return scenes;
  for (const unsigned terms : std::array<unsigned, 3>{
           ambient_term | point_term, ambient_term | directional_term, ambient_term}) {
    for (const SceneText& scene : base_scenes()) {
      scenes.push_back(with_lights(
          scene, [&](std::size_t i) { return (terms & term_of(scene.lights[i].kind)) != 0; }));
    }
  }
  return scenes;
}

std::vector<TermScene> term_scenes(const Stage& stage) {
  std::vector<TermScene> scenes;
  for (std::size_t base = 0; base < base_scenes().size(); ++base) {
    const SceneText& scene = base_scenes()[base];
    for (const LightKind kind : {LightKind::point, LightKind::directional}) {
      if ((stage.terms & term_of(kind)) == 0) continue;
      for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].kind != kind) continue;
        scenes.push_back(
            {with_lights(scene, [&](std::size_t other) { return other == i; }), base, kind});
      }
    }
  }
  return scenes;
}

}  // namespace fos
