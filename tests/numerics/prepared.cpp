#include "prepared.hpp"

#include <mpfr.h>

#include "exact_scene.hpp"

namespace fos::numerics {
namespace {

using reference::Triple;

// More bits than any type here has, so that rounding to them first changes nothing.
constexpr mpfr_prec_t bits = 256;

/// One number of MPFR's.
class Number {
 public:
  explicit Number(const mpq_class& exact) {
    mpfr_init2(value_, bits);
    mpfr_set_q(value_, exact.get_mpq_t(), MPFR_RNDN);
  }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  ~Number() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }

 private:
  mpfr_t value_;
};

template <class T>
T rounded(const Number& number) {
  if constexpr (std::is_same_v<T, float>) return mpfr_get_flt(number.get(), MPFR_RNDN);
  if constexpr (std::is_same_v<T, double>) return mpfr_get_d(number.get(), MPFR_RNDN);
}

template <class T>
T nearest(const mpq_class& exact) {
  return rounded<T>(Number(exact));
}

template <class T>
Vec<T> nearest(const Triple<mpq_class>& v) {
  return {nearest<T>(v[0]), nearest<T>(v[1]), nearest<T>(v[2])};
}

Triple<mpq_class> minus(const Triple<mpq_class>& a, const Triple<mpq_class>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

mpq_class square_length(const Triple<mpq_class>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

template <class T>
Vec<T> normalised(const Triple<mpq_class>& v) {
  Number length(square_length(v));
  mpfr_sqrt(length.get(), length.get(), MPFR_RNDN);
  Vec<T> unit{};
  for (int i = 0; i < 3; ++i) {
    Number component(v[static_cast<std::size_t>(i)]);
    mpfr_div(component.get(), component.get(), length.get(), MPFR_RNDN);
    unit[i] = rounded<T>(component);
  }
  return unit;
}

}  // namespace

template <class T>
PreparedScene<T> prepare(const SceneText& text) {
  const reference::ExactScene exact = reference::to_exact(text);
  PreparedScene<T> scene;
  scene.width = exact.width;
  scene.height = exact.height;
  scene.kx = nearest<T>(mpq_class(exact.viewport_width / exact.width));
  scene.ky = nearest<T>(mpq_class(exact.viewport_height / exact.height));
  scene.d = nearest<T>(exact.projection_plane_d);
  for (const reference::ExactSphere& sphere : exact.spheres) {
    const Triple<mpq_class> V = minus(sphere.center, exact.camera);
    scene.spheres.push_back(
        {nearest<T>(V), nearest<T>(mpq_class(square_length(V) - sphere.radius * sphere.radius)),
         nearest<T>(mpq_class(1 / sphere.radius))});
  }
  scene.ambient_intensity = nearest<T>(exact.ambient);
  for (const reference::ExactLight& light : exact.lights) {
    const T intensity = nearest<T>(light.intensity);
    if (light.is_point) {
      scene.point_lights.push_back({intensity, nearest<T>(minus(light.vector, exact.camera))});
    } else {
      scene.directional_lights.push_back({intensity, normalised<T>(light.vector)});
    }
  }
  return scene;
}

template PreparedScene<float> prepare(const SceneText&);
template PreparedScene<double> prepare(const SceneText&);

}  // namespace fos::numerics
