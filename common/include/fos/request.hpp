// What a stage program is asked: a scene, on its standard input. There is no other kind of request.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "fos/scene_text.hpp"

namespace fos {

struct Request {
  std::string scene_name;  ///< what the file is called in messages
  std::string scene_text;  ///< the whole scene file
  int width = 0;           ///< of the canvas, which may differ from the scene's own
  int height = 0;
};

/// A scene on its own canvas.
Request request_for(const SceneText& scene);

/// A line `scene WIDTH HEIGHT NAME_BYTES TEXT_BYTES`, then the name and the text.
std::string encode(const Request& request);

/// The next request; nothing at the end of the input. Throws std::runtime_error where there is
/// something else.
std::optional<Request> read_request(std::FILE* in);

}  // namespace fos
