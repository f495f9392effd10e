// closest_hit keeps the bound that its header states, at every distance and scale; the slides'
// b² − 4ac, asked the same, does not. Lengths are worked out in 512 bits: exact for what is asked.
#include <gmpxx.h>

#include <algorithm>
#include <random>

#include "catch2.hpp"
#include "fos/closest_hit.hpp"
#include "slides.hpp"

using namespace fos;

namespace {

using Exact = mpf_class;
constexpr mp_bitcnt_t bits = 512;

Exact exact(Real number) {
  int exponent = 0;
  const Real fraction = std::frexp(number, &exponent);
  // A double holds each half of a long double's digits.
  const auto high = static_cast<double>(fraction);
  Exact value(high, bits);
  value += static_cast<double>(fraction - static_cast<Real>(high));
  const auto size = static_cast<mp_bitcnt_t>(std::abs(exponent));
  if (exponent < 0) {
    mpf_div_2exp(value.get_mpf_t(), value.get_mpf_t(), size);
  } else {
    mpf_mul_2exp(value.get_mpf_t(), value.get_mpf_t(), size);
  }
  return value;
}

struct ExactVec {
  Exact x, y, z;
  explicit ExactVec(const Vec3& v) : x(exact(v.x)), y(exact(v.y)), z(exact(v.z)) {}
};
Exact squared(const ExactVec& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

struct Question {
  Vec3 O, D;
  Sphere sphere;
};

/// What a way to the roots is off by, at most, in units of ε (|OC| + r).
struct Worst {
  double surface = 0;     ///< | |O + tD − C| − r |
  double silhouette = 0;  ///< | l − r | where hit and miss are confused
  void operator()(const Question& ask, std::optional<Real> t) {
    const ExactVec O(ask.O);
    const ExactVec D(ask.D);
    const ExactVec C(ask.sphere.center);
    const Exact r = exact(ask.sphere.radius);
    ExactVec V = C;
    V.x -= O.x, V.y -= O.y, V.z -= O.z;
    const Exact unit = exact(std::numeric_limits<Real>::epsilon()) * (sqrt(squared(V)) + r);
    // l = |V × D| / |D|
    ExactVec cross = V;
    cross.x = V.y * D.z - V.z * D.y;
    cross.y = V.z * D.x - V.x * D.z;
    cross.z = V.x * D.y - V.y * D.x;
    const Exact l = sqrt(squared(cross) / squared(D));
    if (t.has_value() != (l <= r)) {
      silhouette = std::max(silhouette, Exact(abs(l - r) / unit).get_d());
    }
    if (!t) return;
    ExactVec X = V;
    const Exact along = exact(*t);
    X.x -= along * D.x, X.y -= along * D.y, X.z -= along * D.z;
    surface = std::max(surface, Exact(abs(sqrt(squared(X)) - r) / unit).get_d());
  }
};

class Questions {
 public:
  Real uniform(double low, double high) {
    return static_cast<Real>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      if (const Real size = length(v); size > Real(0.1) && size <= 1) return v / size;
    }
  }
  /// A ray that passes the centre of a sphere, `distance` radii away, at up to 1.2 r, often at
  /// nearly r; all lengths, and that of D, at any scale.
  Question operator()(double distance) {
    constexpr int scales = std::numeric_limits<Real>::max_exponent / 12;
    const Real scale = std::exp2(uniform(-scales, scales));
    const Real r = scale * std::exp2(uniform(-3, 3));
    const Vec3 toward = direction();
    const Vec3 V = toward * (r * static_cast<Real>(distance) * uniform(0.5, 2));
    const Vec3 O = direction() * (scale * std::exp2(uniform(-6, 6)));
    const Vec3 side = normalize(cross(toward, direction()));
    const bool grazing = uniform(0, 1) < Real(0.5);
    const Real off =
        r * (grazing ? 1 + uniform(-1, 1) * std::exp2(uniform(-30, -3)) : uniform(0, 1.2));
    Vec3 D = V + side * off;
    // From inside, any direction will do, and grazing ones matter from near the surface too.
    if (distance < 2) D = uniform(0, 1) < Real(0.5) ? direction() : side + V * uniform(-0.1, 0.1);
    return {O, normalize(D) * std::exp2(uniform(-8, 8)), {O + V, r, Color(0)}};
  }

 private:
  std::mt19937 random_{4};
};

constexpr double distances[] = {1e-3, 0.9, 0.999999, 1,   1.000001, 1.5, 5,
                                50,   500, 5e3,      5e4, 5e5,      5e6};

}  // namespace

TEST_CASE("a hit lies on its sphere and hit or miss is right, within 12 ε (|OC| + r)") {
  constexpr double K = 12;
  Questions question;
  Worst careful;
  Worst slides;
  for (int i = 0; i < 1500; ++i) {
    for (const double distance : distances) {
      const Question ask = question(distance);
      Scene scene;
      scene.spheres.push_back(ask.sphere);
      const auto near = closest_hit(ask.O, ask.D, -infinity, infinity, scene);
      careful(ask, near ? std::optional(near->t) : std::nullopt);
      if (near) {
        const Real above = std::nextafter(near->t, infinity);
        const auto far = closest_hit(ask.O, ask.D, above, infinity, scene);
        if (far) careful(ask, far->t);
      }
      const auto [t1, t2] = numerics::intersect_ray_sphere<Real>(
          ask.O, ask.D, {ask.sphere.center, ask.sphere.radius});
      for (const Real t : {t1, t2}) slides(ask, t < infinity ? std::optional(t) : std::nullopt);
    }
  }
  INFO("in units of ε (|OC| + r), surface and silhouette: closest_hit "
       << careful.surface << ", " << careful.silhouette << "; the slides' b² − 4ac "
       << slides.surface << ", " << slides.silhouette);
  CHECK(careful.surface <= K);
  CHECK(careful.silhouette <= K);
  // The test tells the two apart: with the slides' formula in closest_hit it would fail.
  CHECK(slides.surface > 100 * K);
  CHECK(slides.silhouette > 100 * K);
}
