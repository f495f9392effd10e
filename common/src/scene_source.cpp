// A scene file from the disk, and what to warn of in it.
#include <fmt/core.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "fos/scene_text.hpp"
#include "fos/text.hpp"

namespace fos {

SceneText read_scene_text(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& reason) -> SceneError {
    return SceneError(fmt::format("{}: {}", say(text::scene_error),
                                  say(text::scene_cannot_read, {path.string(), reason})));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw fail(std::make_error_code(std::errc::is_a_directory).message());
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw fail(std::generic_category().message(errno));
  // One byte more than may be there, so that parse_scene_text can tell; never all of /dev/zero.
  std::string source(max_scene_bytes + 4, '\0');
  file.read(source.data(), static_cast<std::streamsize>(source.size()));
  if (file.bad()) throw fail(std::generic_category().message(errno));
  source.resize(static_cast<std::size_t>(file.gcount()));
  return parse_scene_text(source, path.string());
}

std::vector<std::string> scene_warnings(const SceneText& scene) {
  std::vector<std::string> warnings;
  const auto warn = [&](const Text& what) {
    warnings.push_back(fmt::format("{}: {}: {}", scene.name, say(text::scene_warning), say(what)));
  };
  if (scene.spheres.empty()) warn(text::scene_no_spheres);
  if (scene.lights.empty()) warn(text::scene_no_lights);
  return warnings;
}

}  // namespace fos
