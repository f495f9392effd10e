#include "solutions.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <stdexcept>

#include "fos/nearest.hpp"
#include "fos/stage_program.hpp"

namespace fos::numerics {
namespace {

/// While this lives, what goes to standard error is kept: a stage program says there why it refuses
/// a scene.
class KeptErrors {
 public:
  KeptErrors() : kept_(memfd_create("errors", MFD_CLOEXEC)), own_(dup(2)) { dup2(kept_, 2); }
  ~KeptErrors() {
    dup2(own_, 2);
    close(own_);
    close(kept_);
  }
  KeptErrors(const KeptErrors&) = delete;
  KeptErrors& operator=(const KeptErrors&) = delete;

  /// Of `FILE:LINE:COLUMN: error: message` the message.
  std::string message() const {
    std::string text(4096, '\0');
    const ssize_t size = pread(kept_, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    text.resize(std::min(text.size(), text.find('\n')));
    for (int skipped = 0; skipped < 2; ++skipped) text.erase(0, text.find(": ") + 2);
    return text;
  }

 private:
  int kept_;
  int own_;
};

std::filesystem::path program_of(Precision precision) {
  const std::string path = FOS_SOLUTION;
  return precision == Precision::binary32   ? path + "_float"
         : precision == Precision::extended ? path + "_extended"
                                            : path;
}

/// The colors of the background and of the spheres, by number.
std::vector<std::array<long double, 3>> colors_of(const SceneText& scene) {
  std::vector<std::array<long double, 3>> colors;
  const auto add = [&](const DecimalTriple& color) {
    const auto c = nearest<long double>(color);
    colors.push_back({c.x, c.y, c.z});
  };
  add(scene.background_color);
  for (const SphereText& sphere : scene.spheres) add(sphere.color);
  return colors;
}

/// I, where the pixel is the color times an I.
std::optional<long double> intensity(std::span<const long double, 3> pixel,
                                     const std::array<long double, 3>& color) {
  const auto brightest = std::max_element(color.begin(), color.end());
  const long double I = pixel[static_cast<std::size_t>(brightest - color.begin())] / *brightest;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(pixel[i] - I * color[i]) > 1e-3L * std::abs(I) * *brightest) return std::nullopt;
  }
  return I;
}

Said said(std::span<const long double, 3> pixel,
          const std::vector<std::array<long double, 3>>& colors, int true_sphere) {
  if (!is_finite(pixel)) return {true_sphere, 0, false};
  if (std::equal(pixel.begin(), pixel.end(), colors[0].begin())) return {};
  // Black is any sphere without light: the right one first.
  std::vector<int> spheres{true_sphere};
  for (int i = 1; i < static_cast<int>(colors.size()); ++i) spheres.push_back(i);
  for (const int sphere : spheres) {
    if (sphere == 0) continue;
    const auto I = intensity(pixel, colors[static_cast<std::size_t>(sphere)]);
    if (I) return {sphere, *I, true};
  }
  return {-1, 0, true};
}

}  // namespace

std::variant<std::vector<Said>, std::string> ask_solution(Precision precision,
                                                          const SceneText& scene,
                                                          const Truth& truth) {
  Frame frame;
  Answer answer;
  std::string message;
  {
    const KeptErrors kept;
    StageProgram program(program_of(precision), {std::chrono::seconds(60), 60});
    answer = program.ask(request_for(scene), frame);
    message = kept.message();
  }
  if (answer.ending == Ending::refused) return message;
  if (answer.ending != Ending::complete) {
    throw std::runtime_error(
        program_of(precision).string() + ": " +
        (answer.ending == Ending::did_not_start ? std::strerror(answer.detail) : "no whole frame"));
  }
  const auto colors = colors_of(scene);
  std::vector<Said> all;
  for (int row = 0; row < scene.canvas_height; ++row) {
    for (int column = 0; column < scene.canvas_width; ++column) {
      all.push_back(said(frame.pixel(column, row), colors, truth.pixels[all.size()].sphere));
    }
  }
  return all;
}

}  // namespace fos::numerics
