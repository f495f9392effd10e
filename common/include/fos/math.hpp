// Vectors over Real: GLM's, with its dot, length and normalize, and scalars of any number type.
#pragma once

#include <concepts>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <iosfwd>
#include <limits>
#include <type_traits>

#ifndef FOS_REAL  // the build sets it to float, double or long double, for a whole program at once
#define FOS_REAL double
#endif

namespace fos {

using Real = FOS_REAL;
using Vec3 = glm::vec<3, Real>;

/// Red, green, blue, each 0..255; what a stage returns may lie outside and is clamped when shown.
using Color = Vec3;

using glm::dot;
using glm::length;
using glm::normalize;

/// The slides' `inf`.
inline constexpr Real infinity = std::numeric_limits<Real>::infinity();

template <typename T>
concept OtherNumber = std::is_arithmetic_v<T> && !std::same_as<T, Real>;

}  // namespace fos

// GLM multiplies a vector by its own number type only, and refuses `2 * D` with a page of
// templates. These take any number. They stand in GLM's namespace, so that they are found from
// anywhere.
namespace glm {

template <fos::OtherNumber T>
constexpr fos::Vec3 operator*(T number, const fos::Vec3& v) {
  return static_cast<fos::Real>(number) * v;
}

template <fos::OtherNumber T>
constexpr fos::Vec3 operator*(const fos::Vec3& v, T number) {
  return v * static_cast<fos::Real>(number);
}

template <fos::OtherNumber T>
constexpr fos::Vec3 operator/(const fos::Vec3& v, T number) {
  return v / static_cast<fos::Real>(number);
}

/// `(1, 2, 3)`, for a student's own `std::cout << N`. (A template, so that <ostream>, which costs
/// each stage a third of its compiling, is needed only by who prints.)
template <class Traits>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                             const fos::Vec3& v) {
  return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
}

}  // namespace glm
