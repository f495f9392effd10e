#include "certified.hpp"

#include <algorithm>

#include "exact_hit.hpp"
#include "exact_pixel.hpp"

namespace fos::certified {
namespace {

/// Rows whose spheres are looked for together.
constexpr int band = 8;

/// For each band of rows the spheres that it may show, the nearest first.
std::vector<std::vector<int>> bands(const CameraScene& scene, const Plan& plan) {
  std::vector<std::vector<int>> lists(static_cast<std::size_t>((scene.height + band - 1) / band));
  for (const int i : plan.spheres) {
    const CameraSphere& sphere = scene.spheres[static_cast<std::size_t>(i)];
    const int first = plan.within_outlines ? sphere.first_row / band : 0;
    const int end =
        plan.within_outlines ? (sphere.end_row + band - 1) / band : static_cast<int>(lists.size());
    for (int k = first; k < end; ++k) lists[static_cast<std::size_t>(k)].push_back(i);
  }
  return lists;
}

}  // namespace

Renderer::Renderer(const SceneText& scene, reference::Terms terms, std::optional<Plan> plan)
    : exact_(reference::to_exact(scene)),
      terms_(terms),
      scene_(camera_scene(exact_, terms)),
      plan_(plan ? *std::move(plan) : certified::plan(scene_)),
      lights_(float_lights(scene_, plan_.replaced)),
      bands_(bands(scene_, plan_)) {
  for (int column = 0; column < scene_.width; ++column) {
    background_.insert(background_.end(), scene_.background.begin(), scene_.background.end());
  }
}

Effort Renderer::render(Picture& picture, Claims* claims) const {
  picture.width = scene_.width;
  picture.height = scene_.height;
  const auto row_bytes = static_cast<std::size_t>(scene_.width) * 3;
  picture.rgb.resize(row_bytes * static_cast<std::size_t>(scene_.height) + row_padding);

  const bool in_float = plan_.in_float && lights_.suit;
  RowTask task{scene_.width,
               static_cast<float>(scene_.kx),
               0,
               static_cast<float>(scene_.d),
               scene_.background,
               plan_.shade,
               &lights_,
               {},
               nullptr};
  RowClaims row_claims{};
  if (claims != nullptr) {
    const std::size_t room = picture.rgb.size() / 3 + row_padding;
    claims->I.assign(room, 0);
    claims->error.resize(room);
    task.claims = &row_claims;
  }
  std::vector<RowSphere> spheres;
  std::vector<Undecided> undecided;
  Rest rest{DoublePixel(scene_), {}};
  Effort effort;
  for (int row = 0; row < scene_.height; ++row) {
    std::uint8_t* const rgb = picture.rgb.data() + row_bytes * static_cast<std::size_t>(row);
    std::copy(background_.begin(), background_.end(), rgb);
    spheres.clear();
    for (const int i : bands_[static_cast<std::size_t>(row / band)]) {
      const CameraSphere& sphere = scene_.spheres[static_cast<std::size_t>(i)];
      if (plan_.within_outlines && (row < sphere.first_row || row >= sphere.end_row)) continue;
      RowSphere along;
      if (!along_row(scene_, sphere, scene_.y(row), plan_.within_outlines, along)) continue;
      along.in_float &= in_float;
      spheres.push_back(along);
    }
    std::sort(spheres.begin(), spheres.end(),
              [](const auto& a, const auto& b) { return a.nearest_t < b.nearest_t; });
    task.Y = static_cast<float>(scene_.ky * scene_.y(row));
    task.spheres = spheres;
    if (claims != nullptr) {
      row_claims = {claims->I.data() + row_bytes / 3 * static_cast<std::size_t>(row),
                    claims->error.data() + row_bytes / 3 * static_cast<std::size_t>(row)};
      std::fill_n(row_claims.error, row_bytes / 3, -1.0F);  // the row above may have written here
    }
    undecided.clear();
    float_row(task, rgb, undecided);
    effort.in_float += scene_.width - static_cast<long>(undecided.size());
    finish_row(row, spheres, undecided, rest, rgb, effort);
  }
  picture.rgb.resize(row_bytes * static_cast<std::size_t>(scene_.height));
  return effort;
}

void Renderer::finish_row(int row, const std::vector<RowSphere>& spheres,
                          const std::vector<Undecided>& undecided, Rest& rest, std::uint8_t* rgb,
                          Effort& effort) const {
  auto& [in_double, candidates] = rest;
  for (const auto& [column, known] : undecided) {
    candidates.clear();
    if (known != nullptr) candidates.push_back(known);
    for (const RowSphere& each : spheres) {
      if (known == nullptr && each.first_column <= column && column < each.end_column) {
        candidates.push_back(each.sphere);
      }
    }
    std::optional<Bytes> bytes = in_double.bytes(candidates, scene_.x(column), scene_.y(row));
    ++(bytes ? effort.in_double : effort.exact);
    if (!bytes) bytes = exact_bytes(column, row, candidates, in_double);
    std::copy(bytes->begin(), bytes->end(), rgb + static_cast<std::ptrdiff_t>(column) * 3);
  }
}

Bytes Renderer::exact_bytes(int column, int row, std::span<const CameraSphere* const> candidates,
                            const DoublePixel& in_double) const {
  std::vector<int> indices;
  for (const CameraSphere* sphere : candidates) indices.push_back(sphere->index);
  std::sort(indices.begin(), indices.end());  // of two equal t the first in the scene counts
  const auto hit =
      reference::exact_hit(exact_, reference::exact_direction(exact_, column, row), indices);
  if (!hit) return scene_.background;
  const auto sphere = std::find_if(candidates.begin(), candidates.end(),
                                   [&](const auto* each) { return each->index == hit->sphere; });
  const auto rounded = [](const mpq_class& x) { return Bounded::rounded(to_double(x)); };
  const Bounded root = sqrt(rounded(hit->root.discriminant));
  const Bounded minus_b = -rounded(hit->root.b);
  const Bounded t = (hit->root.sign < 0 ? minus_b - root : minus_b + root) /
                    (Bounded::exactly(2) * rounded(hit->root.a));
  const auto bytes = in_double.shaded(**sphere, t, scene_.x(column), scene_.y(row));
  return bytes ? *bytes : exact_pixel(exact_, terms_, column, row).bytes;
}

}  // namespace fos::certified
