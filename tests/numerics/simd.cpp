#include "simd.hpp"

// Each target costs a compilation of everything below, so only those that differ in what is needed
// here: SSE4, AVX2, AVX3, and the baseline (which is scalar code in Highway 1.0.3, SSE2 in later
// ones).
#include <hwy/detect_targets.h>
#if HWY_ARCH_X86
#undef HWY_DISABLED_TARGETS
#ifdef HWY_AVX3_ZEN4
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_AVX3_ZEN4)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fos::numerics::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Triple {
  V x, y, z;
};

template <class V>
HWY_INLINE V dot(const Triple<V>& a, const Triple<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <class D, class T>
HWY_INLINE Triple<hn::Vec<D>> set(D d, const Vec<T>& v) {
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

template <class V>
struct Lit {
  V sphere;  // its number, as a number of the lanes' own type
  V I;
};

/// trace_prepared in each lane; there is why.
template <class D, class T = hn::TFromD<D>, class V = hn::Vec<D>>
HWY_INLINE Lit<V> trace(D d, const Triple<V>& ray, const PreparedScene<T>& scene) {
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, T{1});
  const V a = dot(ray, ray);
  V closest_t = hn::Set(d, std::numeric_limits<T>::infinity());
  V number = zero;
  V inverse_r = zero;
  Triple<V> center{zero, zero, zero};
  T count = 0;
  for (const PreparedSphere<T>& sphere : scene.spheres) {
    ++count;
    const Triple<V> C = set(d, sphere.V);
    const V h = dot(C, ray);
    const V c = hn::Set(d, sphere.c);
    const V discriminant = hn::MulSub(h, h, hn::Mul(a, c));
    const auto meets = hn::Ge(discriminant, zero);
    if (hn::AllFalse(d, meets)) continue;
    const V q = hn::Add(h, hn::CopySign(hn::Sqrt(discriminant), h));
    V t = hn::Div(c, q);
    const auto first = hn::Ge(t, one);
    if (!hn::AllTrue(d, first)) t = hn::IfThenElse(first, t, hn::Div(q, a));
    const auto closer = hn::And(meets, hn::And(hn::Ge(t, one), hn::Lt(t, closest_t)));
    closest_t = hn::IfThenElse(closer, t, closest_t);
    number = hn::IfThenElse(closer, hn::Set(d, count), number);
    inverse_r = hn::IfThenElse(closer, hn::Set(d, sphere.inverse_r), inverse_r);
    center = {hn::IfThenElse(closer, C.x, center.x), hn::IfThenElse(closer, C.y, center.y),
              hn::IfThenElse(closer, C.z, center.z)};
  }
  V I = hn::Set(d, scene.ambient_intensity);
  const auto hit = hn::Gt(number, zero);
  if (hn::AllFalse(d, hit)) return {number, I};

  // Where nothing is hit, t is infinite and what follows is of no account.
  const Triple<V> P{hn::Mul(closest_t, ray.x), hn::Mul(closest_t, ray.y),
                    hn::Mul(closest_t, ray.z)};
  const Triple<V> N{hn::Mul(hn::Sub(P.x, center.x), inverse_r),
                    hn::Mul(hn::Sub(P.y, center.y), inverse_r),
                    hn::Mul(hn::Sub(P.z, center.z), inverse_r)};
  for (const LightOf<T>& light : scene.point_lights) {
    const Triple<V> M = set(d, light.vector);
    const Triple<V> L{hn::Sub(M.x, P.x), hn::Sub(M.y, P.y), hn::Sub(M.z, P.z)};
    const V n_dot_l = dot(N, L);
    const auto lit = hn::And(hit, hn::Gt(n_dot_l, zero));
    if (hn::AllFalse(d, lit)) continue;
    const V term = hn::Div(hn::Mul(hn::Set(d, light.intensity), n_dot_l), hn::Sqrt(dot(L, L)));
    I = hn::Add(I, hn::IfThenElseZero(lit, term));
  }
  for (const LightOf<T>& light : scene.directional_lights) {
    const V n_dot_l = dot(N, set(d, light.vector));
    const V term = hn::Mul(hn::Set(d, light.intensity), n_dot_l);
    I = hn::Add(I, hn::IfThenElseZero(hn::Gt(n_dot_l, zero), term));
  }
  return {number, I};
}

/// A vector of sphere numbers, as integers of 32 bits.
template <class D>
HWY_INLINE void store_numbers(D /*d*/, hn::Vec<D> numbers, std::int32_t* out) {
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    const hn::RebindToSigned<D> integers;
    hn::StoreU(hn::ConvertTo(integers, numbers), integers, out);
  } else {
    const hn::Rebind<std::int32_t, D> integers;
    hn::StoreU(hn::DemoteTo(integers, numbers), integers, out);
  }
}

template <class T>
HWY_NOINLINE void render(const PreparedScene<T>& scene, Canvas<T>& out) {
  const hn::ScalableTag<T> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  const auto width = static_cast<std::size_t>(scene.width);
  const V kx = hn::Set(d, scene.kx);
  const V middle = hn::Set(d, static_cast<T>(scene.width) / 2);
  const T top = static_cast<T>(scene.height) / 2 - 1;
  T* I = out.I.data();
  std::int32_t* sphere = out.sphere.data();
  for (int row = 0; row < scene.height; ++row, I += width, sphere += width) {
    const V y = hn::Set(d, (top - static_cast<T>(row)) * scene.ky);
    for (std::size_t column = 0; column < width; column += lanes) {
      const V columns = hn::Iota(d, static_cast<T>(column));
      const Triple<V> ray{hn::Mul(hn::Sub(columns, middle), kx), y, hn::Set(d, scene.d)};
      const Lit<V> lit = trace(d, ray, scene);
      if (column + lanes <= width) {
        hn::StoreU(lit.I, d, I + column);
        store_numbers(d, lit.sphere, sphere + column);
      } else {  // the end of a row that is no whole number of vectors
        HWY_ALIGN T some_I[HWY_MAX_BYTES / sizeof(T)];
        HWY_ALIGN std::int32_t some_spheres[HWY_MAX_BYTES / sizeof(std::int32_t)];
        hn::Store(lit.I, d, some_I);
        store_numbers(d, lit.sphere, some_spheres);
        std::copy(some_I, some_I + (width - column), I + column);
        std::copy(some_spheres, some_spheres + (width - column), sphere + column);
      }
    }
  }
}

void render_float(const PreparedScene<float>& scene, Canvas<float>& out) { render(scene, out); }
void render_double(const PreparedScene<double>& scene, Canvas<double>& out) { render(scene, out); }
const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace fos::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fos::numerics {

HWY_EXPORT(render_float);
HWY_EXPORT(render_double);
HWY_EXPORT(target_name);

void render_simd(const PreparedScene<float>& scene, Canvas<float>& out) {
  HWY_DYNAMIC_DISPATCH(render_float)(scene, out);
}
void render_simd(const PreparedScene<double>& scene, Canvas<double>& out) {
  HWY_DYNAMIC_DISPATCH(render_double)(scene, out);
}
std::string simd_target() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

}  // namespace fos::numerics
#endif
