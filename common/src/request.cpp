#include "fos/request.hpp"

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

#include "fos/text.hpp"

namespace fos {

Request request_for(const SceneText& scene) {
  return {scene.name, scene.source, scene.canvas_width, scene.canvas_height};
}

std::string encode(const Request& request) {
  return fmt::format("scene {} {} {} {}\n{}{}", request.width, request.height,
                     request.scene_name.size(), request.scene_text.size(), request.scene_name,
                     request.scene_text);
}

std::optional<Request> read_request(std::FILE* in) {
  Request request;
  std::size_t name_bytes = 0;
  std::size_t text_bytes = 0;
  const int read = std::fscanf(in, "scene %d %d %zu %zu", &request.width, &request.height,
                               &name_bytes, &text_bytes);
  if (read == EOF) return std::nullopt;
  const auto fits = [](int side) { return side >= 1 && side <= max_canvas; };
  bool whole = read == 4 && std::fgetc(in) == '\n' && name_bytes <= max_scene_bytes &&
               text_bytes <= max_scene_bytes && fits(request.width) && fits(request.height);
  for (auto& [text, bytes] :
       {std::pair{&request.scene_name, name_bytes}, {&request.scene_text, text_bytes}}) {
    if (!whole) break;
    text->resize(bytes);
    whole = std::fread(text->data(), 1, bytes, in) == bytes;
  }
  if (!whole) throw std::runtime_error(say(text::stage_bad_request));
  return request;
}

}  // namespace fos
