// The main of every stage program: scenes in on standard input, frames out on descriptor 3, for as
// many requests as come. Standard output and error are the student's, to print what they like.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <system_error>

#include "fos/frame.hpp"
#include "fos/request.hpp"
#include "fos/scene_file.hpp"
#include "fos/text.hpp"

namespace {

constexpr int frame_descriptor = 3;

constexpr fos::Precision precision = std::same_as<fos::Real, float>    ? fos::Precision::binary32
                                     : std::same_as<fos::Real, double> ? fos::Precision::binary64
                                                                       : fos::Precision::extended;

void write_all(std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(frame_descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw std::system_error(errno, std::generic_category());
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void answer(const fos::Request& request) {
  fos::SceneFile file =
      fos::to_scene(fos::parse_scene_text(request.scene_text, request.scene_name));
  file.view.canvas_width = request.width;
  file.view.canvas_height = request.height;
  const fos::FrameHeader header{file.view.canvas_width, file.view.canvas_height, precision};
  write_all(fos::encode(header));
  std::vector<char> bytes(fos::encoded_row_size(header));
  fos::render(file.scene, file.view, [&](auto colors, auto unwritten) {
    static_assert(sizeof(fos::Color) == 3 * sizeof(fos::Real));
    std::memcpy(bytes.data(), colors.data(), colors.size_bytes());
    std::memcpy(bytes.data() + colors.size_bytes(), unwritten.data(), unwritten.size());
    write_all(bytes);
  });
}

}  // namespace

int main() {
  if (fcntl(frame_descriptor, F_GETFD) == -1) {
    std::cerr << fos::say(fos::text::stage_run_by_lab) << '\n';
    return 2;
  }
  try {
    while (const auto request = fos::read_request(std::cin)) answer(*request);
  } catch (const std::system_error& error) {  // nobody reads the frame, or the descriptor is shut
    std::cerr << error.what() << '\n';
    return 3;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
