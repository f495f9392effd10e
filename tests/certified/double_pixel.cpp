#include "double_pixel.hpp"

#include <algorithm>
#include <vector>

#include "bounded.hpp"

namespace fos::certified {
namespace {

using Vector = std::array<Bounded, 3>;

Vector rounded(const Triple& v) {
  return {Bounded::rounded(v[0]), Bounded::rounded(v[1]), Bounded::rounded(v[2])};
}
inline Bounded dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

constexpr Bounded one = Bounded::exactly(1);

/// (h² − ac), by the way that cancels less: for a sphere that is farther away than it is wide,
/// a r² − |V × D|² (Lagrange's identity).
Bounded quarter_discriminant(const CameraSphere& sphere, const Vector& V, const Vector& D,
                             const Bounded& a, const Bounded& h) {
  if (sphere.V_length <= 2 * sphere.r) return h * h - a * Bounded::rounded(sphere.c);
  const Vector cross{V[1] * D[2] - V[2] * D[1], V[2] * D[0] - V[0] * D[2],
                     V[0] * D[1] - V[1] * D[0]};
  const Bounded r = Bounded::rounded(sphere.r);
  return a * r * r - dot(cross, cross);
}

/// I at the hit; nothing but zeros added to I_A leaves `lit` false.
Bounded intensity(const CameraScene& scene, const CameraSphere& sphere, const Bounded& t,
                  const Vector& D, bool& lit) {
  const Vector V = rounded(sphere.V);
  const Bounded inv_r = one / Bounded::rounded(sphere.r);
  Vector P;
  Vector N;
  for (std::size_t i = 0; i < 3; ++i) {
    P[i] = t * D[i];
    N[i] = (P[i] - V[i]) * inv_r;
  }
  Bounded I = Bounded::rounded(scene.ambient);
  lit = false;
  for (const CameraLight& light : scene.lights) {
    Vector L = rounded(light.is_point ? light.M : light.direction);
    if (light.is_point) {
      for (std::size_t i = 0; i < 3; ++i) L[i] = L[i] - P[i];
    }
    Bounded n_dot_l = dot(N, L);
    if (n_dot_l.high() <= 0) continue;
    lit = true;
    // Where it may be negative, the positive part is within the same bound.
    const Bounded cosine = n_dot_l / sqrt(dot(L, L));
    const Bounded term = Bounded::rounded(light.I) * cosine;
    // (A NaN is neither below 0 nor kept by std::max, and must stay one.)
    I = I + (term.value() < 0 ? Bounded(0, term.high() <= 0 ? 0.0 : term.high()) : term);
  }
  return I;
}

std::optional<std::uint8_t> byte_of(const Bounded& channel) {
  const auto byte = [](double x) { return std::nearbyint(std::min(255.0, std::max(0.0, x))); };
  const double low = byte(channel.low());
  const double high = byte(channel.high());
  if (!(channel.low() <= channel.high()) || low != high) return std::nullopt;
  return static_cast<std::uint8_t>(low);
}

}  // namespace

/// Appends the sphere's nearest root with t >= 1, or what may be it; false if there may be more.
bool DoublePixel::add_candidates(const CameraSphere& sphere, const Vector& D, const Bounded& a) {
  const Vector V = rounded(sphere.V);
  const Bounded h = dot(V, D);
  const Bounded disc = quarter_discriminant(sphere, V, D, a, h);
  if (disc.high() < 0) return true;
  const bool is_sure = disc.low() >= 0;
  const Bounded root = sqrt(disc);
  const Bounded c = Bounded::rounded(sphere.c);
  // The root without cancellation, and the other from t1 t2 = c/a.
  const bool in_front = h.value() >= 0;
  const Bounded q = in_front ? h + root : h - root;
  const Bounded through_c = c / q;
  const Bounded through_a = q / a;
  const Bounded& near = in_front ? through_c : through_a;
  const Bounded& far = in_front ? through_a : through_c;
  for (const Bounded& t : {near, far}) {
    if (t.high() < 1) continue;
    if (!(t.low() > -std::numeric_limits<double>::infinity())) return false;
    const bool in_range = t.low() >= 1;
    candidates_.push_back({&sphere, t, is_sure && in_range});
    if (in_range) break;
  }
  return true;
}

DoublePixel::Vector DoublePixel::direction(double x, double y) const {
  return {Bounded::exactly(x) * Bounded::rounded(scene_.kx),
          Bounded::exactly(y) * Bounded::rounded(scene_.ky), Bounded::rounded(scene_.d)};
}

std::optional<Bytes> DoublePixel::bytes(std::span<const CameraSphere* const> spheres, double x,
                                        double y) {
  const Vector D = direction(x, y);
  const Bounded a = dot(D, D);
  candidates_.clear();
  for (const CameraSphere* sphere : spheres) {
    if (!add_candidates(*sphere, D, a)) return std::nullopt;
  }
  if (candidates_.empty()) return scene_.background;

  // The sure one whose farthest is nearest; all others must be behind it.
  const Candidate* nearest = nullptr;
  for (const Candidate& candidate : candidates_) {
    if (candidate.sure && (nearest == nullptr || candidate.t.high() < nearest->t.high())) {
      nearest = &candidate;
    }
  }
  if (nearest == nullptr) return std::nullopt;
  for (const Candidate& candidate : candidates_) {
    if (&candidate != nearest && !is_less(nearest->t, candidate.t)) return std::nullopt;
  }
  return shaded(*nearest->sphere, nearest->t, D);
}

std::optional<Bytes> DoublePixel::shaded(const CameraSphere& sphere, const Bounded& t, double x,
                                         double y) const {
  return shaded(sphere, t, direction(x, y));
}

std::optional<Bytes> DoublePixel::shaded(const CameraSphere& sphere, const Bounded& t,
                                         const Vector& D) const {
  bool lit = false;
  const Bounded I = intensity(scene_, sphere, t, D, lit);
  if (!lit) return sphere.unlit;
  Bytes bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto byte = byte_of(Bounded::rounded(sphere.color[i]) * I);
    if (!byte) return std::nullopt;
    bytes[i] = *byte;
  }
  return bytes;
}

}  // namespace fos::certified
