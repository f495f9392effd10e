#include "rational_term.hpp"

#include <cstddef>

namespace fos::reference {
namespace {

/// The root of x >= 0, if it is rational.
std::optional<mpq_class> rational_sqrt(const mpq_class& x) {
  if (!mpz_perfect_square_p(x.get_num_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) {
    return std::nullopt;
  }
  return mpq_class(sqrt(x.get_num()), sqrt(x.get_den()));
}

/// Whether <N, L> = 0. It is p + q t with rational p and q, because t^2 = -(b t + c) / a:
/// directional: <CO + t D, L> = CO.L + t D.L;
/// point, with M = S - O for the light at S: <CO + t D, M - t D> = CO.M + c + t (D.M + CO.D).
bool is_perpendicular(const ExactScene& scene, const Triple<mpq_class>& CO, const mpq_class& r,
                      const Triple<mpq_class>& D, const ExactRoot& root, const ExactLight& light) {
  const Triple<mpq_class> M = light.is_point ? light.vector - scene.camera : light.vector;
  mpq_class p = dot(CO, M);
  mpq_class q = dot(D, M);
  if (light.is_point) {
    p += squared_length(CO) - square(r);
    q += dot(CO, D);
  }
  return q == 0 ? p == 0 : is_at(root, mpq_class(-p / q));
}

}  // namespace

std::optional<mpq_class> rational_term(const ExactScene& scene, const Triple<mpq_class>& D,
                                       const ExactHit& hit, const ExactLight& light) {
  const ExactSphere& sphere = scene.spheres[static_cast<std::size_t>(hit.sphere)];
  const Triple<mpq_class> CO = scene.camera - sphere.center;
  if (is_perpendicular(scene, CO, sphere.radius, D, hit.root, light)) return 0;

  const std::optional<mpq_class> root = rational_sqrt(hit.root.discriminant);
  if (!root) return std::nullopt;
  const mpq_class t = (-hit.root.b + hit.root.sign * *root) / (2 * hit.root.a);
  const Triple<mpq_class> N = CO + t * D;
  const Triple<mpq_class> P = scene.camera + t * D;
  const Triple<mpq_class> L = light.is_point ? light.vector - P : light.vector;
  const mpq_class N_dot_L = dot(N, L);
  const std::optional<mpq_class> cosine =
      rational_sqrt(square(N_dot_L) / (square(sphere.radius) * squared_length(L)));
  if (!cosine) return std::nullopt;
  return mpq_class(sgn(N_dot_L) * light.intensity * *cosine);
}

}  // namespace fos::reference
