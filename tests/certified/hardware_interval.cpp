#include "hardware_interval.hpp"

#include "interval.hpp"

namespace fos::certified {
namespace {

/// MPFR's own conversions may compute; that they kept the number is checked.
template <class Real>
Real kept(Real converted, mpfr_srcptr exact) {
  mpfr_t back;
  mpfr_init2(back, 128);
  mpfr_set_ld(back, static_cast<long double>(converted), MPFR_RNDN);
  if (mpfr_equal_p(back, exact) == 0) std::feraiseexcept(FE_INVALID);
  mpfr_clear(back);
  return converted;
}

float to_real(mpfr_srcptr x, float /*of this type*/) { return kept(mpfr_get_flt(x, MPFR_RNDN), x); }
double to_real(mpfr_srcptr x, double /*of this type*/) { return kept(mpfr_get_d(x, MPFR_RNDN), x); }
long double to_real(mpfr_srcptr x, long double /*of this type*/) {
  return kept(mpfr_get_ld(x, MPFR_RNDN), x);
}

}  // namespace

template <class Real>
HardwareInterval<Real>::HardwareInterval(mpfr_prec_t /*bits*/, const mpq_class& exact) {
  const reference::Interval rounded(digits, exact);
  minus_low_ = -to_real(rounded.low(), Real{});
  high_ = to_real(rounded.high(), Real{});
}

template HardwareInterval<float>::HardwareInterval(mpfr_prec_t, const mpq_class&);
template HardwareInterval<double>::HardwareInterval(mpfr_prec_t, const mpq_class&);
template HardwareInterval<long double>::HardwareInterval(mpfr_prec_t, const mpq_class&);

}  // namespace fos::certified
