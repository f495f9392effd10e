// Points and directions over exact numbers or intervals, with the few operations the slides need.
#pragma once

#include <array>

#include "interval.hpp"

namespace fos::reference {

template <class Number>
using Triple = std::array<Number, 3>;

inline mpq_class square(const mpq_class& x) { return x * x; }

template <class Number>
Triple<Number> operator+(const Triple<Number>& a, const Triple<Number>& b) {
  return {Number(a[0] + b[0]), Number(a[1] + b[1]), Number(a[2] + b[2])};
}

template <class Number>
Triple<Number> operator-(const Triple<Number>& a, const Triple<Number>& b) {
  return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class Number>
Triple<Number> operator*(const Number& s, const Triple<Number>& a) {
  return {Number(s * a[0]), Number(s * a[1]), Number(s * a[2])};
}

template <class Number>
Number dot(const Triple<Number>& a, const Triple<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// dot(a, a); for intervals narrower than dot, because it knows that both factors are the same.
template <class Number>
Number squared_length(const Triple<Number>& a) {
  return square(a[0]) + square(a[1]) + square(a[2]);
}

/// Of intervals.
template <class Number>
Number length(const Triple<Number>& a) {
  return sqrt(squared_length(a));
}

template <class Number = Interval>
Triple<Number> to_intervals(mpfr_prec_t bits, const Triple<mpq_class>& a) {
  return {Number(bits, a[0]), Number(bits, a[1]), Number(bits, a[2])};
}

}  // namespace fos::reference
