#include "float_row.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

// The instruction sets to compile for; which one runs is decided at run time.
#define HWY_DISABLED_TARGETS (HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "float_row.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fos::certified::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<float>;
using V = hn::Vec<Tag>;
using M = hn::Mask<Tag>;
constexpr Tag tag;

HWY_INLINE V set(float value) { return hn::Set(tag, value); }
HWY_INLINE M none() { return hn::FirstN(tag, 0); }

/// Errors are bounded to first order; where they are not small, nothing is decided.
constexpr float small = 1.0F / 64;

/// What a group of neighbouring pixels sees, with t in [low, high].
struct Nearest {
  V t;
  V P_error;  ///< eP/t
  V low;
  V high;
  V sphere;  ///< which of the winners, -1 for none
  M unsure;
};

/// About 1/x for an x >= 0, and large for 0.
HWY_INLINE V reciprocal(V x) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
  return hn::ApproximateReciprocal(hn::Max(x, set(0x1p-100F)));  // theirs of 0 is 0
#else
  return hn::ApproximateReciprocal(x);
#endif
}

/// A sphere's hit in each pixel, as far as floats can tell.
struct Hit {
  V t;
  V P_error;  ///< eP/t
  V error;    ///< of t, relative, with what comparing t rounds
  M sure;
  M missed;
};

HWY_INLINE V higher(const Hit& h) { return hn::MulAdd(h.t, h.error, h.t); }
HWY_INLINE V lower(const Hit& h) { return hn::NegMulAdd(h.t, h.error, h.t); }

HWY_INLINE Hit hit(const RowTask& task, const RowSphere& s, V x) {
  // The letters, and every bound, are row_sphere.hpp's.
  const V delta = hn::Sub(hn::Sub(x, set(s.xi)), set(s.xf));
  const V T = hn::Mul(set(s.k), hn::Mul(delta, delta));
  const V disc = hn::Sub(set(s.q), T);
  const V root = hn::Sqrt(hn::Max(disc, set(0)));
  const V h = hn::MulAdd(set(s.hx), x, set(s.h0));
  V E = set(s.E);
  V rate = set(s.P_rate);
  if (s.k < 0) {
    E = hn::MulAdd(set(T_share), hn::Abs(T), E);
    rate = hn::Mul(rate, E);
  }
  const V P_error = hn::MulAdd(rate, reciprocal(root), set(s.P_error));
  const V error = hn::MulAdd(P_error, set(s.inv_D), set(2 * u));
  Hit result{hn::Div(set(s.c), hn::Add(hn::Abs(h), root)), P_error, error, hn::Gt(disc, E),
             hn::Lt(disc, hn::Neg(E))};
  const M behind = hn::Lt(h, set(0));
  if (s.roots != Roots::far && !s.in_front) {
    result.missed = hn::Or(result.missed, behind);
    result.sure = hn::AndNot(behind, result.sure);
  }
  if (s.roots != Roots::near) {
    const V X = hn::Mul(set(task.kx), x);
    const V far = hn::Div(hn::Add(hn::Abs(h), root), hn::MulAdd(X, X, set(s.a0)));
    const M is_far = s.roots == Roots::far ? hn::Not(behind) : hn::Lt(higher(result), set(1));
    result.t = hn::IfThenElse(is_far, far, result.t);
    // What is shown has t >= 1.
    result.missed = hn::Or(result.missed, hn::Lt(higher(result), set(1)));
    result.sure = hn::And(result.sure, hn::Ge(lower(result), set(1)));
  }
  return result;
}

/// Takes the sphere in where it is the nearest so far; false where it is that nowhere.
HWY_INLINE bool take_in(const Hit& h, float number, M open, Nearest& nearest) {
  const V low = lower(h);
  const V high = higher(h);
  const M nearer = hn::And(h.sure, hn::Lt(high, nearest.low));
  const M farther = hn::Or(h.missed, hn::And(h.sure, hn::Gt(low, nearest.high)));
  nearest.unsure = hn::Or(nearest.unsure, hn::And(open, hn::Not(hn::Or(nearer, farther))));
  nearest.t = hn::IfThenElse(nearer, h.t, nearest.t);
  nearest.P_error = hn::IfThenElse(nearer, h.P_error, nearest.P_error);
  nearest.low = hn::IfThenElse(nearer, low, nearest.low);
  nearest.high = hn::IfThenElse(nearer, high, nearest.high);
  nearest.sphere = hn::IfThenElse(nearer, set(number), nearest.sphere);
  return !hn::AllFalse(tag, nearer);
}

/// Sums terms and the bounds of their errors.
struct Light {
  HWY_INLINE explicit Light(const FloatLights& lights)
      : many(lights.many), I(set(lights.ambient)), lost(set(0)), error(set(0)), lit(none()) {}

  HWY_INLINE void add(V term, V bound) {
    const M on = hn::Gt(term, hn::Neg(bound));
    lit = hn::Or(lit, on);
    error = hn::Add(error, hn::IfThenElseZero(on, bound));
    const V part = hn::Max(term, set(0));  // 0 where it is not on
    if (!many) {
      I = hn::Add(I, part);
      return;
    }
    // Kahan's sum: its error does not grow with the number of lights.
    const V rest = hn::Sub(part, lost);
    const V sum = hn::Add(I, rest);
    lost = hn::Sub(hn::Sub(sum, I), rest);
    I = sum;
  }

  bool many;
  V I;
  V lost;
  V error;
  M lit;
};

struct Pixels {
  std::array<V, 3> shades;  ///< the bytes of the sphere's shades
  M decided;
  V I;
  V error;
};

HWY_INLINE V dot(V ax, V ay, V az, V bx, V by, V bz) {
  return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, hn::Mul(az, bz)));
}

/// 1/√x, off by at most 6.6u of itself.
HWY_INLINE V inverse_sqrt(V x) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  // The processor's estimate is within 1.5 2^-12 (its manual says); a step of Newton's leaves 3/2
  // of the square of that, 3.4u, and rounds by 3.1u. It takes a third of the time of √ and
  // division.
  const V y = hn::ApproximateReciprocalSqrt(x);
  const V xyy = hn::Mul(hn::Mul(x, y), y);
  return hn::Mul(y, hn::NegMulAdd(set(0.5F), xyy, set(1.5F)));
#else
  return hn::Div(set(1), hn::Sqrt(x));
#endif
}

HWY_INLINE Pixels shaded(const RowTask& task, const RowSphere& s, V x, V t, V P_error) {
  const FloatLights& lights = *task.lights;
  const V Px = hn::Mul(t, hn::Mul(set(task.kx), x));
  const V Py = hn::Mul(t, set(task.Y));
  const V Pz = hn::Mul(t, set(task.d));
  const V inv_r = set(s.sphere->inv_r);
  const V Nx = hn::MulSub(Px, inv_r, set(s.sphere->W[0]));
  const V Ny = hn::MulSub(Py, inv_r, set(s.sphere->W[1]));
  const V Nz = hn::MulSub(Pz, inv_r, set(s.sphere->W[2]));
  const V eP = hn::Mul(t, P_error);
  const V eN = hn::MulAdd(eP, inv_r, set(s.n0));
  M good = hn::And(hn::Le(hn::Mul(P_error, set(s.inv_D)), set(small)), hn::Le(eN, set(small)));

  Light light(lights);
  for (const FloatDirectional& each : lights.directional) {
    const V term = dot(Nx, Ny, Nz, set(each.x), set(each.y), set(each.z));
    light.add(term, hn::MulAdd(set(each.I), eN, set(each.rest)));
  }
  for (const FloatPoint& each : lights.point) {
    const V Lx = hn::Sub(set(each.x), Px);
    const V Ly = hn::Sub(set(each.y), Py);
    const V Lz = hn::Sub(set(each.z), Pz);
    const V inverse = inverse_sqrt(dot(Lx, Ly, Lz, Lx, Ly, Lz));
    const V w = hn::Mul(hn::Add(eP, set(each.m)), inverse);
    // (An L too short for its square to be a normal float makes w infinite, of either sign.)
    good = hn::And(good, hn::Le(hn::Abs(w), set(small)));
    const V cosine = hn::Mul(dot(Nx, Ny, Nz, Lx, Ly, Lz), inverse);
    const V bound = hn::MulAdd(set(each.I), hn::MulAdd(set(2.1F), w, eN), set(each.rest));
    light.add(hn::Mul(set(each.I), cosine), bound);
  }

  // The bytes at both ends of what I may be.
  const V error =
      hn::MulAdd(set(lights.error_share), light.error, hn::Mul(set(lights.sum_share), light.I));
  const CameraSphere& sphere = *s.sphere;
  std::array<V, 3> shades{set(0), set(0), set(0)};
  M same = good;
  for (int i = 0; i < sphere.shade_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const V color = set(sphere.shades[k]);
    const bool color_may_clip = sphere.shades[k] * lights.brightest > 255.4F;
    const V channel = hn::Mul(color, light.I);
    V low = hn::NegMulAdd(color, error, channel);
    V high = hn::MulAdd(color, error, channel);
    if (color_may_clip) {  // (of Min's arguments the second is kept if it is NaN)
      low = hn::Min(set(255), low);
      high = hn::Min(set(255), high);
    }
    high = hn::Round(high);
    same = hn::And(same, hn::Eq(hn::Round(low), high));
    shades[k] = hn::IfThenElse(light.lit, high, set(sphere.unlit_shades[k]));
  }
  return {shades, hn::Or(same, hn::AndNot(light.lit, good)), light.I,
          hn::IfThenElse(good, error, set(-1))};
}

HWY_INLINE Pixels unlit(const CameraSphere& sphere) {
  const auto shade = [&](std::size_t i) { return set(sphere.unlit_shades[i]); };
  return {{shade(0), shade(1), shade(2)}, hn::Not(none()), set(0), set(0)};
}

HWY_INLINE Pixels pixels_of(const RowTask& task, const RowSphere& s, V x, V t, V P_error) {
  return task.shade ? shaded(task, s, x, t, P_error) : unlit(*s.sphere);
}

HWY_INLINE auto to_u8(V bytes) {
  const hn::Rebind<std::uint8_t, Tag> tag8;
  return hn::DemoteTo(tag8, hn::NearestInt(bytes));
}

HWY_INLINE void claim(M here, const Pixels& pixels, int column, RowClaims& claims) {
  hn::BlendedStore(pixels.I, here, tag, claims.I + column);
  hn::BlendedStore(pixels.error, here, tag, claims.error + column);
}

HWY_INLINE void report(M unsure, const CameraSphere* sphere, int column, int width,
                       std::vector<Undecided>& undecided) {
  if (hn::AllFalse(tag, unsure)) return;
  std::array<std::uint8_t, 8> bits{};
  hn::StoreMaskBits(tag, unsure, bits.data());
  const int lanes = static_cast<int>(hn::Lanes(tag));
  for (int i = 0; i < lanes && column + i < width; ++i) {
    const auto byte = bits[static_cast<std::size_t>(i / 8)];
    if ((byte >> (i % 8) & 1) != 0) undecided.push_back({column + i, sphere});
  }
}

/// Of a column's bytes in its row.
constexpr std::ptrdiff_t offset_of(int column) { return std::ptrdiff_t{3} * column; }

/// Stores pixels that show one sphere.
HWY_INLINE void store(const Pixels& pixels, const CameraSphere& sphere, std::uint8_t* rgb) {
  const auto black = to_u8(set(0));
  std::array<decltype(to_u8(set(0))), 4> channels{black, black, black, black};
  for (int i = 0; i < sphere.shade_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    channels[k + 1] = to_u8(pixels.shades[k]);
  }
  const auto channel = [&](std::size_t i) {
    return channels[static_cast<std::size_t>(sphere.shade_of[i]) + 1];
  };
  hn::StoreInterleaved3(channel(0), channel(1), channel(2), hn::Rebind<std::uint8_t, Tag>(), rgb);
}

/// Pixels, as many as a vector has lanes, that show different things or that floats are not sure
/// of. `first` is the candidate whose hit is known, the nearest.
HWY_NOINLINE void mixed_group(const RowTask& task, std::span<const int> candidates, int column,
                              V columns, V x, const Hit* first, std::uint8_t* rgb,
                              std::vector<Undecided>& undecided) {
  const int lanes = static_cast<int>(hn::Lanes(tag));
  std::array<const RowSphere*, 32> winners{};
  std::size_t count = 0;
  Nearest nearest{set(0), set(0), set(1e38F), set(1e38F), set(-1), none()};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const RowSphere& s = task.spheres[static_cast<std::size_t>(candidates[i])];
    if (s.end_column <= column || s.first_column >= column + lanes) continue;
    const M open = hn::Not(hn::Lt(nearest.high, set(s.nearest_t)));
    if (hn::AllFalse(tag, open)) break;
    if (!s.in_float || count == winners.size()) {
      const M there = hn::And(hn::Ge(columns, set(static_cast<float>(s.first_column))),
                              hn::Lt(columns, set(static_cast<float>(s.end_column))));
      nearest.unsure = hn::Or(nearest.unsure, hn::And(open, there));
    } else if (take_in(i == 0 && first != nullptr ? *first : hit(task, s, x),
                       static_cast<float>(count), open, nearest)) {
      winners[count++] = &s;
    }
  }

  if (count > 0) {
    std::array<V, 3> bytes{set(task.background[0]), set(task.background[1]),
                           set(task.background[2])};
    for (std::size_t i = 0; i < count; ++i) {
      const M here = hn::Eq(nearest.sphere, set(static_cast<float>(i)));
      if (hn::AllFalse(tag, here)) continue;
      const Pixels pixels = pixels_of(task, *winners[i], x, nearest.t, nearest.P_error);
      for (std::size_t k = 0; k < 3; ++k) {
        const int shade = winners[i]->sphere->shade_of[k];
        const V byte = shade < 0 ? set(0) : pixels.shades[static_cast<std::size_t>(shade)];
        bytes[k] = hn::IfThenElse(here, byte, bytes[k]);
      }
      const M open = hn::AndNot(hn::Or(nearest.unsure, pixels.decided), here);
      report(open, winners[i]->sphere, column, task.width, undecided);
      if (task.claims != nullptr) {
        claim(hn::AndNot(nearest.unsure, here), pixels, column, *task.claims);
      }
    }
    hn::StoreInterleaved3(to_u8(bytes[0]), to_u8(bytes[1]), to_u8(bytes[2]),
                          hn::Rebind<std::uint8_t, Tag>(), rgb + offset_of(column));
  }
  report(nearest.unsure, nullptr, column, task.width, undecided);
}

/// The pixels from `column` on, as many as a vector has lanes; `candidates` overlap them, or lie in
/// the same section.
HWY_INLINE void group(const RowTask& task, std::span<const int> candidates, int column,
                      std::uint8_t* rgb, std::vector<Undecided>& undecided) {
  const int lanes = static_cast<int>(hn::Lanes(tag));
  const auto overlaps = [&](const RowSphere& s) {
    return s.first_column < column + lanes && column < s.end_column;
  };
  while (!candidates.empty() && !overlaps(task.spheres[static_cast<std::size_t>(candidates[0])])) {
    candidates = candidates.subspan(1);
  }
  if (candidates.empty()) return;
  const V columns = hn::Iota(tag, static_cast<float>(column));
  const V x = hn::Sub(columns, set(static_cast<float>(task.width) / 2));
  const RowSphere& s = task.spheres[static_cast<std::size_t>(candidates[0])];
  if (!s.in_float) {
    mixed_group(task, candidates, column, columns, x, nullptr, rgb, undecided);
    return;
  }
  // Mostly all of them surely show the nearest sphere, and no other can be in front of it.
  const Hit h = hit(task, s, x);
  M alone = h.sure;
  if (candidates.size() > 1) {
    const V next = set(task.spheres[static_cast<std::size_t>(candidates[1])].nearest_t);
    alone = hn::And(alone, hn::Lt(higher(h), next));
  }
  if (!hn::AllTrue(tag, alone)) {
    mixed_group(task, candidates, column, columns, x, &h, rgb, undecided);
    return;
  }
  const Pixels pixels = pixels_of(task, s, x, h.t, h.P_error);
  if (task.claims != nullptr) claim(hn::Not(none()), pixels, column, *task.claims);
  store(pixels, *s.sphere, rgb + offset_of(column));
  report(hn::Not(pixels.decided), s.sphere, column, task.width, undecided);
}

/// Pixels with one list of candidates: long, so that there are few lists, but not much longer than
/// a sphere is wide.
constexpr int section = 64;

void float_row(const RowTask& task, std::uint8_t* rgb, std::vector<Undecided>& undecided) {
  static thread_local std::vector<std::vector<int>> candidates;
  candidates.resize(static_cast<std::size_t>((task.width + section - 1) / section));
  for (std::vector<int>& list : candidates) list.clear();
  for (std::size_t i = 0; i < task.spheres.size(); ++i) {
    const RowSphere& s = task.spheres[i];
    for (int k = s.first_column / section; k * section < s.end_column; ++k) {
      candidates[static_cast<std::size_t>(k)].push_back(static_cast<int>(i));
    }
  }
  const int lanes = static_cast<int>(hn::Lanes(tag));
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (candidates[k].empty()) continue;
    const int first = static_cast<int>(k) * section;
    for (int column = first; column < std::min(first + section, task.width); column += lanes) {
      group(task, candidates[k], column, rgb, undecided);
    }
  }
}

const char* float_row_target() { return hwy::TargetName(HWY_TARGET); }

}  // namespace fos::certified::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fos::certified {

HWY_EXPORT(float_row);
HWY_EXPORT(float_row_target);

void float_row(const RowTask& task, std::uint8_t* rgb, std::vector<Undecided>& undecided) {
  HWY_DYNAMIC_DISPATCH(float_row)(task, rgb, undecided);
}

const char* float_row_target() { return HWY_DYNAMIC_DISPATCH(float_row_target)(); }

}  // namespace fos::certified
#endif
