// mistake_pictures SCENE FOLDER: for each mistake of the catalogue FOLDER/ID.png, the right picture
// on the left and the wrong one on the right. It is the lecture's scene where the mistake shows
// there, else the diagnostic scene where it shows most.
#include <fmt/core.h>

#include <exception>
#include <filesystem>

#include "diagnostic_scenes.hpp"
#include "fos/picture.hpp"
#include "scene_at.hpp"

namespace {

constexpr int side = 120;  // pixels of each of the two
constexpr int gap = 4;

/// The last stage that a mistake can be made in has all the light there is.
const fos::Stage* stage_of(const fos::Misconception& mistake) {
  const fos::Stage* last = nullptr;
  for (const fos::Stage& stage : fos::stages) {
    if ((mistake.stages & fos::stage_bit(stage.id)) != 0) last = &stage;
  }
  return last;
}

fos::Frame frame_of(fos::SceneText scene, const fos::Stage& stage,
                    const fos::MistakeSet& mistakes) {
  scene.canvas_width = scene.canvas_height = side;
  return fos::mistaken_frame(fos::SceneAt<double>(scene), stage.terms, mistakes);
}

/// How many pixels a person sees differ.
int visible(const fos::Frame& right, const fos::Frame& wrong) {
  int pixels = 0;
  for (std::size_t i = 0; i < right.channels.size(); i += 3) {
    int most = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      most = std::max(most,
                      std::abs(fos::to_byte(right.channels[k]) - fos::to_byte(wrong.channels[k])));
    }
    pixels += most > 8 ? 1 : 0;
  }
  return pixels;
}

void write_pair(const std::filesystem::path& path, const fos::Frame& right,
                const fos::Frame& wrong) {
  fos::PictureWriter writer(path, {2 * side + gap, side, fos::Precision::binary64}, {});
  for (int row = 0; row < side; ++row) {
    fos::Row pixels;
    for (int column = 0; column < 2 * side + gap; ++column) {
      const bool is_right = column < side;
      const bool is_gap = !is_right && column < side + gap;
      const int from = is_right ? column : column - side - gap;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        pixels.channels.push_back(is_gap ? 255
                                         : (is_right ? right : wrong).pixel(from, row)[channel]);
      }
      pixels.unwritten.push_back(0);
    }
    writer.write(pixels);
  }
  writer.finish();
}

void make_picture(const fos::Misconception& mistake, const fos::SceneText& lecture,
                  const std::filesystem::path& folder) {
  const fos::Stage* stage = stage_of(mistake);
  if (stage == nullptr) return;
  fos::Frame right = frame_of(lecture, *stage, {});
  fos::Frame wrong = frame_of(lecture, *stage, {mistake.mistake});
  int most = visible(right, wrong);
  const bool shows_in_lecture = most > side * side / 50;
  for (const fos::SceneText& scene : fos::base_scenes()) {
    if (shows_in_lecture) break;
    fos::Frame also_right = frame_of(scene, *stage, {});
    fos::Frame also_wrong = frame_of(scene, *stage, {mistake.mistake});
    const int shows = visible(also_right, also_wrong);
    if (shows <= most) continue;
    most = shows;
    right = std::move(also_right);
    wrong = std::move(also_wrong);
  }
  write_pair(folder / fmt::format("{}.png", mistake.id), right, wrong);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: mistake_pictures SCENE FOLDER\n");
    return 2;
  }
  try {
    const fos::SceneText lecture = fos::read_scene_text(argv[1]);
    for (const fos::Misconception& each : fos::misconceptions()) {
      make_picture(each, lecture, argv[2]);
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "mistake_pictures: {}\n", error.what());
    return 3;
  }
}
