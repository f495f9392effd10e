#include "chain.hpp"

#include <algorithm>
#include <utility>

#include "exact_hit.hpp"
#include "exact_pixel.hpp"
#include "fos/stage_list.hpp"
#include "surd.hpp"

namespace fos {
namespace {

using reference::Enclosure;
using reference::ExactScene;
using reference::Triple;

/// I and the channels to this part of themselves at least: more digits than are ever shown.
constexpr int bits_of_I = 80;

Triple<Enclosure> enclose(const SurdField& field, const Triple<Surd>& x) {
  return {field.enclose(x[0]), field.enclose(x[1]), field.enclose(x[2])};
}

Triple<Surd> to_surds(const Triple<mpq_class>& x) {
  return {Surd{x[0], 0}, Surd{x[1], 0}, Surd{x[2], 0}};
}

template <class Number>
Triple<Number> minus(const Triple<Number>& x, const Triple<Number>& y) {
  return {Number(x[0] - y[0]), Number(x[1] - y[1]), Number(x[2] - y[2])};
}

SphereMet meet(const ExactScene& scene, const reference::ExactSphere& sphere,
               const Triple<mpq_class>& D) {
  const Triple<mpq_class> CO = minus(scene.camera, sphere.center);
  const mpq_class a = reference::squared_length(D);
  const mpq_class b = 2 * reference::dot(CO, D);
  const mpq_class c = reference::squared_length(CO) - reference::square(sphere.radius);
  SphereMet met;
  met.discriminant = b * b - 4 * a * c;
  if (sgn(met.discriminant) < 0) return met;
  const SurdField field(met.discriminant);
  for (std::size_t i = 0; i < 2; ++i) {
    const mpq_class half(i == 0 ? 1 : -1, 2);
    const Surd t = field.number(-b / (2 * a), half / a);
    met.roots[i] = field.enclose(t);
    met.counts[i] = field.sign(t - Surd{1, 0}) >= 0;
  }
  return met;
}

/// The point that a ray sees, in numbers over its discriminant.
class Point {
 public:
  Point(const ExactScene& scene, const Triple<mpq_class>& D, const reference::ExactHit& hit)
      : field_(hit.root.discriminant) {
    const reference::ExactSphere& sphere = scene.spheres[static_cast<std::size_t>(hit.sphere)];
    const mpq_class two_a = 2 * hit.root.a;
    t_ = field_.number(-hit.root.b / two_a, hit.root.sign / two_a);
    for (std::size_t i = 0; i < 3; ++i) {
      P_[i] = Surd{scene.camera[i], 0} + D[i] * t_;
      N_[i] = (1 / sphere.radius) * (P_[i] - Surd{sphere.center[i], 0});  // |CP| = r
    }
  }

  void describe(Hit& hit) const {
    hit.t = field_.enclose(t_);
    hit.P = enclose(field_, P_);
    hit.N = enclose(field_, N_);
  }

  LightMet meet(const reference::ExactLight& light) const {
    LightMet met;
    Triple<Surd> L = to_surds(light.vector);
    if (light.is_point) L = minus(L, P_);
    met.L = enclose(field_, L);
    const Surd squared = field_.dot(L, L);
    if (field_.sign(squared) == 0) {
      met.shine = Shine::at_P;
      return met;
    }
    const Surd N_dot_L = field_.dot(N_, L);
    const int sign = field_.sign(N_dot_L);
    met.shine = sign > 0 ? Shine::lit : sign < 0 ? Shine::behind : Shine::grazing;
    if (sign != 0) met.N_dot_L = field_.enclose(N_dot_L);
    met.L_length = square_root(field_.enclose(squared));
    met.cosine = quotient(met.N_dot_L, met.L_length);
    met.degrees = degrees(met.cosine);
    if (sign > 0) met.term = product(light.intensity, met.cosine);
    return met;
  }

 private:
  SurdField field_;
  Surd t_;
  Triple<Surd> P_;
  Triple<Surd> N_;
};

}  // namespace

unsigned oracle_terms(unsigned terms) {
  if (terms == 0) return reference::flat;
  return ((terms & ambient_term) != 0 ? reference::ambient : 0U) |
         ((terms & point_term) != 0 ? reference::point : 0U) |
         ((terms & directional_term) != 0 ? reference::directional : 0U);
}

Chain certified_chain(const SceneText& scene, unsigned terms, int column, int row) {
  const ExactScene exact = reference::to_exact(scene);
  Chain chain;
  chain.x = exact.canvas_x(column);
  chain.y = exact.canvas_y(row);
  chain.D = reference::exact_direction(exact, column, row);
  for (const reference::ExactSphere& sphere : exact.spheres) {
    chain.spheres.push_back(meet(exact, sphere, chain.D));
  }
  Triple<mpq_class> color = exact.background_color;
  if (const auto seen = reference::exact_hit(exact, chain.D)) {
    Hit hit;
    hit.sphere = seen->sphere + 1;
    hit.root = seen->root.sign < 0 ? 1 : 0;
    const Point point(exact, chain.D, *seen);
    point.describe(hit);
    std::size_t next = 0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      if (scene.lights[i].kind == LightKind::ambient) continue;
      hit.lights.push_back(point.meet(exact.lights[next++]));
      hit.lights.back().index = i;
    }
    chain.hit = std::move(hit);
    color = exact.spheres[static_cast<std::size_t>(seen->sphere)].color;
  }
  const certified::ExactPixel pixel =
      certified::exact_pixel(exact, oracle_terms(terms), column, row, bits_of_I);
  chain.I = pixel.I;
  for (std::size_t i = 0; i < 3; ++i) chain.channels[i] = product(color[i], chain.I);
  chain.bytes = pixel.bytes;
  return chain;
}

}  // namespace fos
