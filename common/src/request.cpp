#include "fos/request.hpp"

#include <fmt/core.h>

#include <stdexcept>

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

std::optional<Request> read_request(std::istream& in) {
  if (in.peek() == std::istream::traits_type::eof()) return std::nullopt;
  Request request;
  std::string word;
  std::size_t name_bytes = 0;
  std::size_t text_bytes = 0;
  in >> word >> request.width >> request.height >> name_bytes >> text_bytes;
  const bool fits = word == "scene" && in.get() == '\n' && name_bytes <= max_scene_bytes &&
                    text_bytes <= max_scene_bytes && request.width >= 1 &&
                    request.width <= max_canvas && request.height >= 1 &&
                    request.height <= max_canvas;
  if (fits) {
    request.scene_name.resize(name_bytes);
    request.scene_text.resize(text_bytes);
    in.read(request.scene_name.data(), static_cast<std::streamsize>(name_bytes));
    in.read(request.scene_text.data(), static_cast<std::streamsize>(text_bytes));
  }
  if (!fits || !in) throw std::runtime_error(say(text::stage_bad_request));
  return request;
}

}  // namespace fos
