#include "exact_hit.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include "exact_sign.hpp"

namespace fos::reference {
namespace {

/// The sign of root - t, because 2a > 0.
int compare(const ExactRoot& root, const mpq_class& t) {
  return sign_of_sum(mpq_class(-root.b - 2 * root.a * t), Root{root.sign, root.discriminant});
}

/// The sign of r - s, for roots along the same ray, which have the same a.
int compare(const ExactRoot& r, const ExactRoot& s) {
  return sign_of_sum(mpq_class(s.b - r.b), Root{r.sign, r.discriminant},
                     Root{-s.sign, s.discriminant});
}

/// The nearest root with t >= 1, if there is one.
std::optional<ExactRoot> exact_root(const ExactScene& scene, const ExactSphere& sphere,
                                    const Triple<mpq_class>& D, const mpq_class& a) {
  const Triple<mpq_class> CO = scene.camera - sphere.center;
  const mpq_class b = 2 * dot(CO, D);
  const mpq_class c = squared_length(CO) - square(sphere.radius);
  const mpq_class discriminant = b * b - 4 * a * c;
  if (sgn(discriminant) < 0) return std::nullopt;
  for (const int sign : {-1, 1}) {
    ExactRoot root{a, b, discriminant, sign};
    if (compare(root, 1) >= 0) return root;
  }
  return std::nullopt;
}

}  // namespace

Triple<mpq_class> exact_direction(const ExactScene& scene, int column, int row) {
  return {mpq_class(scene.canvas_x(column) * scene.viewport_width / scene.width),
          mpq_class(scene.canvas_y(row) * scene.viewport_height / scene.height),
          scene.projection_plane_d};
}

std::optional<ExactHit> exact_hit(const ExactScene& scene, const Triple<mpq_class>& D) {
  std::vector<int> all(scene.spheres.size());
  std::iota(all.begin(), all.end(), 0);
  return exact_hit(scene, D, all);
}

std::optional<ExactHit> exact_hit(const ExactScene& scene, const Triple<mpq_class>& D,
                                  std::span<const int> spheres) {
  const mpq_class a = squared_length(D);
  std::optional<ExactHit> nearest;
  for (const int i : spheres) {
    std::optional<ExactRoot> root =
        exact_root(scene, scene.spheres[static_cast<std::size_t>(i)], D, a);
    if (root && (!nearest || compare(*root, nearest->root) < 0)) {
      nearest = ExactHit{i, *std::move(root)};
    }
  }
  return nearest;
}

bool is_at(const ExactRoot& root, const mpq_class& t) { return compare(root, t) == 0; }

}  // namespace fos::reference
